// Designs to start from; each can be made as it is.

const strip = (spline, more = {}) => ({ label: "A1", curve: { spline, degree: 4 }, ...more });
const design = (name, sheet, max_width, spline, more = {}) => ({ schema: 1, name, sheet, max_width, strips: [strip(spline)], ...more });

export const STARTS = [
  design("arch", "birch-plywood-0.8", 40, [[0, 0], [40, 5], [80, 40], [125, 160], [200, 175], [275, 160], [320, 40], [360, 5], [400, 0]]),
  design("s-curve", "birch-plywood-0.8", 40, [[0, 0], [65, 50], [125, 65], [210, -65], [275, -50], [345, 0]]),
  design("bow", "pom-1", 25, [[0, 0], [20, 60], [90, 110], [160, 60], [180, 0]]),
  design("hook", "spring-steel-0.2", 15, [[0, 0], [60, 0], [110, 10], [130, 45], [100, 75], [60, 65]]),
  {
    ...design("lamp", "polypropylene-0.8", 30, [[60, 0], [75, 20], [110, 60], [110, 120], [75, 160], [60, 180]]),
    strips: [strip([[60, 0], [75, 20], [110, 60], [110, 120], [75, 160], [60, 180]], { label: "L{i}" })],
    patterns: [{ rotate: { count: 12 } }], ends: { length: 24 }, rings: { sheet: "mdf-3", gap: 10 },
  },
];
