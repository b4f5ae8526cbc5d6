// What the page says, in German and Chinese, by its English text.

const DE = {
  "Undo": "Rückgängig", "Redo": "Wiederholen", "Draw": "Zeichnen", "Move": "Bewegen", "Fit": "Alles zeigen",
  "Zoom in": "Vergrößern", "Zoom out": "Verkleinern", "Snap": "Fangraster", "off": "aus", "grid": "Raster",
  "Start from": "Beginnen mit", "Empty drawing": "Leere Zeichnung", "Open": "Öffnen", "Save": "Speichern", "Close": "Schließen",
  "Copy link": "Link kopieren", "Copied": "Kopiert", "Download": "Herunterladen", "Design file": "Entwurfsdatei", "Kit as zip": "Bausatz als Zip",
  "PDF at 1:1": "PDF im Maßstab 1:1", "Strip": "Streifen", "Control point": "Kontrollpunkt", "Remove": "Entfernen", "Inflection": "Wendepunkt",
  "Not on the line": "Nicht auf der Geraden", "The line meets the curve": "Die Gerade trifft die Kurve",
  "It can be made": "Machbar", "It can be made, with care": "Machbar, mit Vorsicht", "It cannot be made": "Nicht machbar",
  "Draw at least three points": "Zeichnen Sie mindestens drei Punkte",
  "Click on the drawing to set the first points of a curve, or start from an example.": "Klicken Sie auf die Zeichenfläche, um die ersten Punkte einer Kurve zu setzen, oder beginnen Sie mit einem Beispiel.",
  "Nearest curve": "Nächste Kurve", "Take it": "Übernehmen", "Leave it": "Verwerfen", "Sheets that can do it": "Geeignete Platten",
  "The nearest curve is": "Die nächste Kurve ist entfernt um", "fits": "passt", "does not": "passt nicht",
  "length": "Länge", "width": "Breite", "stiffness ratio": "Steifigkeitsverhältnis", "strain": "Dehnung", "of what the sheet bears": "dessen, was die Platte trägt",
  "stability": "Stabilität", "mass": "Masse", "held by": "gehalten mit", "off the drawn curve": "neben der gezeichneten Kurve",
  "unstable": "instabil", "low": "gering", "ample": "reichlich",
  "Flat strip": "Flacher Streifen", "Bent strip": "Gebogener Streifen", "Bend it": "Biegen", "flat": "flach", "as drawn": "wie gezeichnet", "it snaps": "es schnappt um",
  "force": "Kraft", "moment": "Moment", "Copies": "Kopien", "Around the axis x = 0": "Um die Achse x = 0", "Holders": "Halter", "none": "keine",
  "Rings": "Ringe", "Base plate": "Grundplatte", "Printed blocks": "Gedruckte Blöcke", "Whatever fits": "Was passt", "Sheet of the holders": "Platte der Halter",
  "Show the whole model": "Ganzes Modell zeigen", "Settings": "Einstellungen", "name": "Name", "Language": "Sprache",
  "The server has ended. Your design stays in this page and its address: run elastica studio again.": "Der Server wurde beendet. Ihr Entwurf bleibt auf dieser Seite und in ihrer Adresse: Starten Sie elastica studio erneut.",
  "This browser shows no 3D: it needs WebGL.": "Dieser Browser zeigt kein 3D: Er braucht WebGL.", "The bent strip in space; arrow keys turn it": "Der gebogene Streifen im Raum; Pfeiltasten drehen ihn",
  "The drawing: Tab goes to its points, arrow keys move them, Insert adds one, Delete removes one": "Die Zeichnung: Tab führt zu den Punkten, Pfeiltasten bewegen sie, Einfg fügt einen ein, Entf entfernt einen",
  "Working": "Wird gemacht", "Saved": "Gespeichert", "yes": "ja", "no": "nein", "more": "mehr", "as below": "wie unten",
  "Try": "Versuchen", "Drop SVG, DXF or CSV on the drawing": "SVG, DXF oder CSV auf die Zeichnung ziehen", "Choose a curve": "Eine Kurve wählen",
  "This strip is given by formulae; its design file says it.": "Dieser Streifen ist durch Formeln gegeben; sie stehen in der Entwurfsdatei.",
};

const ZH = {
  "Undo": "撤销", "Redo": "重做", "Draw": "绘制", "Move": "移动", "Fit": "全部显示", "Zoom in": "放大", "Zoom out": "缩小", "Snap": "吸附", "off": "关", "grid": "网格",
  "Start from": "起始示例", "Empty drawing": "空白图", "Open": "打开", "Save": "保存", "Close": "关闭", "Copy link": "复制链接", "Copied": "已复制", "Download": "下载",
  "Design file": "设计文件", "Kit as zip": "套件（zip）", "PDF at 1:1": "1:1 PDF", "Strip": "条带", "Control point": "控制点", "Remove": "删除", "Inflection": "拐点",
  "Not on the line": "不在直线上", "The line meets the curve": "直线与曲线相交", "It can be made": "可以制作", "It can be made, with care": "可以制作，但需小心", "It cannot be made": "无法制作",
  "Draw at least three points": "请至少绘制三个点", "Click on the drawing to set the first points of a curve, or start from an example.": "在图上点击以放置曲线的起始点，或从示例开始。",
  "Nearest curve": "最近的曲线", "Take it": "采用", "Leave it": "放弃", "Sheets that can do it": "可用的板材", "The nearest curve is": "最近的曲线相距", "fits": "适合", "does not": "不适合",
  "length": "长度", "width": "宽度", "stiffness ratio": "刚度比", "strain": "应变", "of what the sheet bears": "（占板材允许值）", "stability": "稳定性", "mass": "质量", "held by": "固定力", "off the drawn curve": "偏离所绘曲线",
  "unstable": "不稳定", "low": "低", "ample": "充足", "Flat strip": "平面条带", "Bent strip": "弯曲条带", "Bend it": "弯曲", "flat": "平", "as drawn": "如所绘", "it snaps": "发生跳变", "force": "力", "moment": "力矩",
  "Copies": "副本", "Around the axis x = 0": "绕轴 x = 0", "Holders": "支架", "none": "无", "Rings": "圆环", "Base plate": "底板", "Printed blocks": "打印块", "Whatever fits": "自动选择", "Sheet of the holders": "支架板材",
  "Show the whole model": "显示整个模型", "Settings": "设置", "name": "名称", "Language": "语言",
  "The server has ended. Your design stays in this page and its address: run elastica studio again.": "服务器已结束。您的设计保留在此页面及其地址中：请重新运行 elastica studio。",
  "This browser shows no 3D: it needs WebGL.": "此浏览器无法显示 3D：需要 WebGL。", "The bent strip in space; arrow keys turn it": "空间中的弯曲条带；方向键可旋转",
  "The drawing: Tab goes to its points, arrow keys move them, Insert adds one, Delete removes one": "绘图区：Tab 键选点，方向键移动，Insert 添加，Delete 删除",
  "Working": "正在处理", "Saved": "已保存", "yes": "是", "no": "否", "more": "更多", "as below": "如下", "Try": "试试",
  "Drop SVG, DXF or CSV on the drawing": "将 SVG、DXF 或 CSV 拖到图上", "Choose a curve": "选择一条曲线", "This strip is given by formulae; its design file says it.": "此条带由公式给出，见设计文件。",
};

export const LANGUAGES = { en: "English", de: "Deutsch", zh: "中文" };
const WORDS = { en: {}, de: DE, zh: ZH };

// The words in one language; `more` holds help texts that the server knows in it.
export function speaker(language, more = {}) {
  return (text) => WORDS[language]?.[text] ?? more[text] ?? text;
}
