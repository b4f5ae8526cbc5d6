// Strain as a share of what the sheet bears, in colours that are told apart on light and on dark ground.

export const STEPS = [0.35, 0.6, 0.8, 1.0, Infinity];
export const COLORS = ["#2f7fd6", "#1f9e89", "#9aa61c", "#e08a1e", "#d8343a"];

export const stepOf = (share) => STEPS.findIndex((most) => share <= most);
