<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
 <name>Elastica</name>
 <message><source>Select a sketch with a spline, or an edge of an object, first.</source><translation>请先选择带样条的草图或对象的边。</translation></message>
 <message><source>Select a strip first.</source><translation>请先选择一个条带。</translation></message>
 <message><source>Select two strips or more first.</source><translation>请先选择两个或更多条带。</translation></message>
 <message><source>Download and install into FreeCAD's own folder?</source><translation>下载并安装到 FreeCAD 自己的文件夹吗？</translation></message>
 <message><source>All optional libraries are installed.</source><translation>所有可选库均已安装。</translation></message>
 <message><source>Select a sketch with a spline first.</source><translation>请先选择带样条的草图。</translation></message>
 <message><source>The nearest curve is</source><translation>最近曲线相距</translation></message>
 <message><source>away</source><translation>远</translation></message>
 <message><source>stays</source><translation>稳定</translation></message>
 <message><source>does not stay</source><translation>不稳定</translation></message>
 <message><source>bent further</source><translation>继续弯曲</translation></message>
 <message><source>largest move</source><translation>最大位移</translation></message>
 <message><source>margin</source><translation>裕度</translation></message>
 <message><source>Save the coupon</source><translation>保存试样</translation></message>
 <message><source>type the readings first: overhang = droop, in mm, such as 120 = 14.5, 150 = 31</source><translation>请先输入读数：悬伸 = 下垂（mm），例如 120 = 14.5, 150 = 31</translation></message>
 <message><source>Longest overhang of the coupon</source><translation>试样最大悬伸</translation></message>
 <message><source>wrote</source><translation>已写出</translation></message>
 <message><source>kept as</source><translation>已存为</translation></message>
 <message><source>Folder for the files</source><translation>文件所在文件夹</translation></message>
 <message><source>choose a folder for the files</source><translation>请选择文件夹</translation></message>
 <message><source>tick what is to be made</source><translation>请勾选要生成的内容</translation></message>
 <message><source>Joints</source><translation>连接</translation></message>
 <message><source>no curve was found: change the limits</source><translation>未找到曲线：请更改限制</translation></message>
 <message><source>Largest distance</source><translation>最大距离</translation></message>
 <message><source>nearest</source><translation>最近</translation></message>
 <message><source>Held away by</source><translation>受限于</translation></message>
 <message><source>Built-in sheets stay: keep yours under another name.</source><translation>内置板材不可删除：请用其他名称保存。</translation></message>
 <message><source>least radius</source><translation>最小半径</translation></message>
 <message><source>elasto-gravity length</source><translation>弹性重力长度</translation></message>
 <message><source>Length</source><translation>长度</translation></message>
 <message><source>Narrowest place</source><translation>最窄处</translation></message>
 <message><source>Stiffness ratio</source><translation>刚度比</translation></message>
 <message><source>Largest strain</source><translation>最大应变</translation></message>
 <message><source>Stability margin</source><translation>稳定裕度</translation></message>
 <message><source>Mass</source><translation>质量</translation></message>
 <message><source>Ranges are those of the sheet.</source><translation>范围取自板材。</translation></message>
 <message><source>deviation</source><translation>偏差</translation></message>
 <message><source>worst</source><translation>最大</translation></message>
 <message><source>Stopped.</source><translation>已停止。</translation></message>
 <message><source>Bending varied strips</source><translation>正在弯曲变化的条带</translation></message>
 <message><source>stiffness range</source><translation>刚度范围</translation></message>
 <message><source>weight</source><translation>重量</translation></message>
 <message><source>end angles</source><translation>端部角度</translation></message>
 <message><source>plasticity</source><translation>塑性</translation></message>
 <message><source>thickness</source><translation>厚度</translation></message>
 <message><source>kerf</source><translation>切缝</translation></message>
 <message><source>combined</source><translation>综合</translation></message>
 <message><source>writes DXF files</source><translation>写 DXF 文件</translation></message>
 <message><source>finds the best widths faster</source><translation>更快求得最佳宽度</translation></message>
 <message><source>Cutting</source><translation>正在切割</translation></message>
 <message><source>Making curves</source><translation>正在生成曲线</translation></message>
 <message><source>Open lines</source><translation>开放线</translation></message>
 <message><source>Closed ones</source><translation>闭合线</translation></message>
 <message><source>the planes miss the object</source><translation>平面与对象不相交</translation></message>
 <message><source>Cancel</source><translation>取消</translation></message>
 <message><source>Constraints on the drawn curve that OK takes away</source><translation>点击确定后将移除的曲线约束</translation></message>
 <message><source>Move or turn an end: type numbers, or drag one of the handles in the view.</source><translation>移动或旋转端部：输入数值，或在视图中拖动一个手柄。</translation></message>
 <message><source>Making the blocks</source><translation>正在生成夹块</translation></message>
 <message><source>Putting the model together</source><translation>正在组装模型</translation></message>
 <message><source>Cutting the mesh</source><translation>正在切割网格</translation></message>
 <message><source>Bending the strip</source><translation>正在弯曲条带</translation></message>
 <message><source>Searching the nearest curve</source><translation>正在搜索最近的曲线</translation></message>
 <message><source>what this panel works on was deleted: press Cancel</source><translation>此面板所处理的对象已被删除：请按取消</translation></message>
 <message><source>the path was deleted: choose another one</source><translation>路径已被删除：请选择另一条</translation></message>
 <message><source>Writing files</source><translation>正在写入文件</translation></message>
 <message><source>tick the box for it</source><translation>请勾选相应的复选框</translation></message>
</context>
<context>
 <name>ElasticaBend</name>
 <message><source>Bend forward</source><translation>继续弯曲</translation></message>
 <message><source>Start of the strip</source><translation>条带起点</translation></message>
 <message><source>Move x</source><translation>x 向位移</translation></message>
 <message><source>Move y</source><translation>y 向位移</translation></message>
 <message><source>Turn</source><translation>转角</translation></message>
 <message><source>End of the strip</source><translation>条带终点</translation></message>
 <message><source>Play</source><translation>播放</translation></message>
</context>
<context>
 <name>ElasticaCheck</name>
 <message><source>Check curve</source><translation>检查曲线</translation></message>
</context>
<context>
 <name>ElasticaCoupon</name>
 <message><source>Coupon and calibrate</source><translation>试样与标定</translation></message>
 <message><source>Coupon</source><translation>试样</translation></message>
 <message><source>Sheet</source><translation>板材</translation></message>
 <message><source>Make the coupon</source><translation>生成试样</translation></message>
 <message><source>Write its cutting file</source><translation>写出切割文件</translation></message>
 <message><source>Readings</source><translation>读数</translation></message>
 <message><source>Overhang = droop, mm</source><translation>悬伸 = 下垂，mm</translation></message>
 <message><source>120 = 14.5, 150 = 31</source><translation>120 = 14.5, 150 = 31</translation></message>
 <message><source>Reading error</source><translation>读数误差</translation></message>
 <message><source>Name of the sheet</source><translation>板材名称</translation></message>
 <message><source>Keep the sheet</source><translation>保存板材</translation></message>
</context>
<context>
 <name>ElasticaExport</name>
 <message><source>Export cutting files</source><translation>导出切割文件</translation></message>
 <message><source>Files</source><translation>文件</translation></message>
 <message><source>DXF</source><translation>DXF</translation></message>
 <message><source>SVG</source><translation>SVG</translation></message>
 <message><source>STEP, flat and bent</source><translation>STEP，平展与弯曲</translation></message>
 <message><source>Cut list (CSV)</source><translation>下料清单 (CSV)</translation></message>
 <message><source>Nest on sheets</source><translation>在板材上排样</translation></message>
 <message><source>Sheet width</source><translation>板材宽度</translation></message>
 <message><source>Sheet height</source><translation>板材高度</translation></message>
 <message><source>How</source><translation>方式</translation></message>
 <message><source>Curves</source><translation>曲线</translation></message>
 <message><source>DXF version</source><translation>DXF 版本</translation></message>
 <message><source>Kerf</source><translation>切缝</translation></message>
 <message><source>Tolerance of arcs and polylines</source><translation>圆弧和折线公差</translation></message>
 <message><source>Where</source><translation>位置</translation></message>
 <message><source>Folder</source><translation>文件夹</translation></message>
 <message><source>Browse...</source><translation>浏览…</translation></message>
 <message><source>Overwrite files that exist</source><translation>覆盖已有文件</translation></message>
</context>
<context>
 <name>ElasticaFixtures</name>
 <message><source>End fixtures and base plate</source><translation>端部夹具与底板</translation></message>
 <message><source>Printed blocks</source><translation>打印夹具</translation></message>
 <message><source>Make blocks for the ends</source><translation>为端部生成夹具</translation></message>
 <message><source>Room around the tab</source><translation>耳片周围间隙</translation></message>
 <message><source>Wall</source><translation>壁厚</translation></message>
 <message><source>Foot</source><translation>底脚</translation></message>
 <message><source>Screw holes</source><translation>螺钉孔</translation></message>
 <message><source>Base plate</source><translation>底板</translation></message>
 <message><source>Make a slotted plate</source><translation>生成开槽板</translation></message>
 <message><source>Sheet</source><translation>板材</translation></message>
 <message><source>Height of its upper face</source><translation>上表面高度</translation></message>
 <message><source>Room beside the tab</source><translation>耳片两侧间隙</translation></message>
 <message><source>Clearance of slots</source><translation>槽间隙</translation></message>
 <message><source>Border</source><translation>边距</translation></message>
</context>
<context>
 <name>ElasticaModel</name>
 <message><source>Interlock strips</source><translation>条带互锁</translation></message>
 <message><source>Slots</source><translation>槽</translation></message>
 <message><source>Cut slots where strips cross</source><translation>在条带相交处开槽</translation></message>
 <message><source>Clearance</source><translation>间隙</translation></message>
 <message><source>Width</source><translation>宽度</translation></message>
 <message><source>Inner ends</source><translation>槽底</translation></message>
</context>
<context>
 <name>ElasticaNearest</name>
 <message><source>Nearest curve</source><translation>最近曲线</translation></message>
 <message><source>Limits</source><translation>限制</translation></message>
 <message><source>Sheet</source><translation>板材</translation></message>
 <message><source>Largest stiffness ratio</source><translation>最大刚度比</translation></message>
 <message><source>Must stay by itself</source><translation>必须自行保持稳定</translation></message>
 <message><source>Least stability margin</source><translation>最小稳定裕度</translation></message>
 <message><source>Keep within the sheet's strain</source><translation>不超过板材应变</translation></message>
 <message><source>Keep</source><translation>保持</translation></message>
 <message><source>End points</source><translation>端点</translation></message>
 <message><source>End tangents</source><translation>端点切线</translation></message>
 <message><source>Length</source><translation>长度</translation></message>
 <message><source>Replace the spline in the sketch</source><translation>替换草图中的样条</translation></message>
</context>
<context>
 <name>ElasticaPreferences</name>
 <message><source>General</source><translation>常规</translation></message>
 <message><source>New strips</source><translation>新条带</translation></message>
 <message><source>Sheet</source><translation>板材</translation></message>
 <message><source>Largest width</source><translation>最大宽度</translation></message>
 <message><source>Tab length</source><translation>耳片长度</translation></message>
 <message><source>Cutting files</source><translation>切割文件</translation></message>
 <message><source>Kerf</source><translation>切缝</translation></message>
 <message><source>Clearance of slots</source><translation>槽间隙</translation></message>
 <message><source>DXF version</source><translation>DXF 版本</translation></message>
 <message><source>Curves</source><translation>曲线</translation></message>
 <message><source>Tolerance of arcs and polylines</source><translation>圆弧和折线公差</translation></message>
 <message><source>While a sketch is edited</source><translation>编辑草图时</translation></message>
 <message><source>Show curvature, inflections and their line</source><translation>显示曲率、拐点及其直线</translation></message>
 <message><source>Show the nearest curve that can be bent</source><translation>显示可弯成的最近曲线</translation></message>
 <message><source>Lengths</source><translation>长度</translation></message>
 <message><source>Shown in</source><translation>显示单位</translation></message>
 <message><source>Unit of all lengths in panels, sentences and the sketch's overlay; files are always in mm</source><translation>面板、提示语句和草图叠加显示中所有长度的单位；文件始终使用 mm</translation></message>
 <message><source>as FreeCAD</source><translation>与 FreeCAD 相同</translation></message>
 <message><source>inch</source><translation>英寸</translation></message>
</context>
<context>
 <name>ElasticaSection</name>
 <message><source>Section into curves</source><translation>剖切成曲线</translation></message>
 <message><source>Planes</source><translation>平面</translation></message>
 <message><source>Tolerance of the curves</source><translation>曲线公差</translation></message>
 <message><source>Family</source><translation>类型</translation></message>
 <message><source>parallel</source><translation>平行</translation></message>
 <message><source>about an axis</source><translation>绕轴</translation></message>
 <message><source>along a path</source><translation>沿路径</translation></message>
 <message><source>Across</source><translation>垂直于</translation></message>
 <message><source>Path</source><translation>路径</translation></message>
 <message><source>Number of planes</source><translation>平面数量</translation></message>
 <message><source>Axis through x</source><translation>轴通过 x</translation></message>
 <message><source>y</source><translation>y</translation></message>
 <message><source>z</source><translation>z</translation></message>
 <message><source>Sweep</source><translation>角度范围</translation></message>
 <message><source>Curves</source><translation>曲线</translation></message>
 <message><source>Closed sections</source><translation>闭合截面</translation></message>
 <message><source>are left out</source><translation>忽略</translation></message>
 <message><source>are split left and right</source><translation>左右分割</translation></message>
 <message><source>are split above and below</source><translation>上下分割</translation></message>
 <message><source>Take out waves shorter than</source><translation>平滑短于此值的波纹</translation></message>
</context>
<context>
 <name>ElasticaSheets</name>
 <message><source>Sheet library</source><translation>板材库</translation></message>
 <message><source>Sheet</source><translation>板材</translation></message>
 <message><source>Name</source><translation>名称</translation></message>
 <message><source>Thickness</source><translation>厚度</translation></message>
 <message><source>Young's modulus</source><translation>杨氏模量</translation></message>
 <message><source>Density</source><translation>密度</translation></message>
 <message><source>Largest strain</source><translation>最大应变</translation></message>
 <message><source>Kerf</source><translation>切缝</translation></message>
 <message><source>Poisson's ratio</source><translation>泊松比</translation></message>
 <message><source>Source</source><translation>来源</translation></message>
 <message><source>Keep as my sheet</source><translation>存为我的板材</translation></message>
 <message><source>Remove my sheet</source><translation>删除我的板材</translation></message>
</context>
<context>
 <name>ElasticaStrip</name>
 <message><source>Strip</source><translation>条带</translation></message>
 <message><source>Sheet and width</source><translation>板材与宽度</translation></message>
 <message><source>Sheet</source><translation>板材</translation></message>
 <message><source>Thickness</source><translation>厚度</translation></message>
 <message><source>Largest width</source><translation>最大宽度</translation></message>
 <message><source>Least width</source><translation>最小宽度</translation></message>
 <message><source>Mechanics</source><translation>力学</translation></message>
 <message><source>Start</source><translation>起点</translation></message>
 <message><source>End</source><translation>终点</translation></message>
 <message><source>Carries its own weight</source><translation>承受自重</translation></message>
 <message><source>Style</source><translation>样式</translation></message>
 <message><source>Outer width</source><translation>外宽</translation></message>
 <message><source>Holes side by side</source><translation>并排孔数</translation></message>
 <message><source>Rows of holes (0: chosen)</source><translation>孔行数（0：自动）</translation></message>
 <message><source>Backing</source><translation>背层</translation></message>
 <message><source>Nearest curve</source><translation>最近曲线</translation></message>
 <message><source>Follow</source><translation>跟随</translation></message>
 <message><source>Largest stiffness ratio</source><translation>最大刚度比</translation></message>
 <message><source>Least stability margin</source><translation>最小稳定裕度</translation></message>
 <message><source>Largest strain, % (0: the sheet's)</source><translation>最大应变，%（0：板材值）</translation></message>
 <message><source>Keep the end tangents</source><translation>保持端点切线</translation></message>
 <message><source>Keep the length</source><translation>保持长度</translation></message>
 <message><source>Ends and text</source><translation>端部与文字</translation></message>
 <message><source>Tab at the start</source><translation>起点耳片</translation></message>
 <message><source>Tab at the end</source><translation>终点耳片</translation></message>
 <message><source>Corner radius</source><translation>圆角半径</translation></message>
 <message><source>Hole in the tabs</source><translation>耳片孔</translation></message>
 <message><source>Engraved text</source><translation>雕刻文字</translation></message>
 <message><source>Quantity</source><translation>数量</translation></message>
 <message><source>Shape</source><translation>形状</translation></message>
</context>
<context>
 <name>ElasticaTolerance</name>
 <message><source>Tolerance study</source><translation>公差研究</translation></message>
 <message><source>Study</source><translation>研究</translation></message>
 <message><source>Bends for each cause</source><translation>每种原因的弯曲次数</translation></message>
 <message><source>Run</source><translation>运行</translation></message>
</context>
<context>
 <name>Elastica_Bend</name>
 <message><source>Bend forward</source><translation>继续弯曲</translation></message>
 <message><source>Move or turn the ends of the selected strip and watch it take its new rest shape</source><translation>移动或转动所选条带的端部，观察其新的静止形状</translation></message>
</context>
<context>
 <name>Elastica_Check</name>
 <message><source>Check curve</source><translation>检查曲线</translation></message>
 <message><source>Say whether a flat strip can take the selected curve, and if not why and where</source><translation>判断平条带能否弯成所选曲线；若不能，说明原因和位置</translation></message>
</context>
<context>
 <name>Elastica_Coupon</name>
 <message><source>Coupon and calibrate</source><translation>试样与标定</translation></message>
 <message><source>Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own</source><translation>生成悬挂试样，并由测得的下垂量得到自己的板材</translation></message>
</context>
<context>
 <name>Elastica_Export</name>
 <message><source>Export cutting files</source><translation>导出切割文件</translation></message>
 <message><source>Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates</source><translation>写出所选条带、模型和底板的 DXF、SVG、STEP 文件、排样和下料清单</translation></message>
</context>
<context>
 <name>Elastica_Fixtures</name>
 <message><source>End fixtures and base plate</source><translation>端部夹具与底板</translation></message>
 <message><source>Make printed blocks that hold the ends of the selected strips or model, or one slotted base plate</source><translation>为所选条带或模型的端部生成打印夹具，或一块开槽底板</translation></message>
</context>
<context>
 <name>Elastica_Interlock</name>
 <message><source>Interlock selected strips</source><translation>互锁所选条带</translation></message>
 <message><source>Put the selected strips together to a model and cut slots where they cross</source><translation>将所选条带组成模型，并在相交处开槽</translation></message>
</context>
<context>
 <name>Elastica_Laminate</name>
 <message><source>Laminate</source><translation>层压</translation></message>
 <message><source>Give the selected strips an even width and glue narrower strips on that make them stiff enough</source><translation>使所选条带等宽，并粘贴较窄的条带以获得足够刚度</translation></message>
</context>
<context>
 <name>Elastica_Libraries</name>
 <message><source>Install missing libraries</source><translation>安装缺少的库</translation></message>
 <message><source>Install the optional libraries that FreeCAD does not bring: ezdxf (DXF files), highspy (faster)</source><translation>安装 FreeCAD 未附带的可选库：ezdxf（DXF 文件）、highspy（更快）</translation></message>
</context>
<context>
 <name>Elastica_Nearest</name>
 <message><source>Nearest curve to sketch</source><translation>草图的最近曲线</translation></message>
 <message><source>Find the curve nearest to the selected sketch that can be bent within limits</source><translation>在限制内寻找与所选草图最接近的可弯曲线</translation></message>
</context>
<context>
 <name>Elastica_Nest</name>
 <message><source>Nest on sheets</source><translation>在板材上排样</translation></message>
 <message><source>Lay everything that must be cut for the selected strips, models and base plates on sheets</source><translation>将所选条带、模型和底板的全部切割件排布到板材上</translation></message>
</context>
<context>
 <name>Elastica_Perforate</name>
 <message><source>Perforate</source><translation>打孔</translation></message>
 <message><source>Give the selected strips an even width and let holes make them as soft as they must be</source><translation>使所选条带等宽，并用孔使其达到所需柔度</translation></message>
</context>
<context>
 <name>Elastica_Section</name>
 <message><source>Section into curves</source><translation>剖切成曲线</translation></message>
 <message><source>Cut the selected body, surface or mesh by planes into smooth curves that strips can follow</source><translation>用平面将所选实体、曲面或网格切割为条带可以跟随的光滑曲线</translation></message>
</context>
<context>
 <name>Elastica_Sheets</name>
 <message><source>Sheet library</source><translation>板材库</translation></message>
 <message><source>Look at the sheets that are known, with their sources, and keep your own</source><translation>查看已知板材及其来源，并保存自己的板材</translation></message>
</context>
<context>
 <name>Elastica_Strip</name>
 <message><source>Strip from sketch</source><translation>由草图生成条带</translation></message>
 <message><source>Make the flat strip that bends into the selected spline: the bent part and, linked to it, the flat one</source><translation>生成可弯成所选样条的平条带：弯曲零件及与之链接的平展零件</translation></message>
</context>
<context>
 <name>Elastica_Tolerance</name>
 <message><source>Tolerance study</source><translation>公差研究</translation></message>
 <message><source>Find how far the bent strip strays when sheet, cut and clamps vary within their ranges</source><translation>研究板材、切割和夹持在其范围内变化时弯曲条带的偏差</translation></message>
</context>
<context>
 <name>Elastica_Projective</name>
 <message><source>Projective edit</source><translation>射影编辑</translation></message>
 <message><source>Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one</source><translation>用四个手柄拉动所选草图的曲线：直线保持为直线，可弯曲的曲线仍可弯曲</translation></message>
</context>
<context>
 <name>ElasticaProjective</name>
 <message><source>Projective edit</source><translation>射影编辑</translation></message>
 <message><source>Put the handles back</source><translation>复位手柄</translation></message>
 <message><source>Handles (x, y)</source><translation>手柄 (x, y)</translation></message>
 <message><source>1, lower left</source><translation>1，左下</translation></message>
 <message><source>2, lower right</source><translation>2，右下</translation></message>
 <message><source>3, upper right</source><translation>3，右上</translation></message>
 <message><source>4, upper left</source><translation>4，左上</translation></message>
</context>
</TS>
