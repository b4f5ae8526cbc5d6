<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Largest distance by which smoothing may move the curve; 0 removes only steps and corners, within 0.1 mm</source>
        <translation>光顺时曲线可移动的最大距离；0 表示仅消除台阶和尖角，移动不超过 0.1 mm</translation>
    </message>
    <message>
        <source>Stop dragged poles where the strip can be made</source>
        <translation>将拖动的控制点停在条带可制作的位置</translation>
    </message>
    <message>
        <source>Expected deviation of a real strip from its design, due to the model, its uncertainty and the sheet</source>
        <translation>实际条带与设计的预期偏差，来自模型、其不确定度和板材</translation>
    </message>
    <message>
        <source>Deviation of the strip as made and held, with its causes</source>
        <translation>条带制成并固定后的偏差及其原因</translation>
    </message>
    <message>
        <source>Largest deviation of the strip, as made and held, from its design</source>
        <translation>条带制成并固定后与设计的最大偏差</translation>
    </message>
    <message>
        <source>The strips, in the order of assembly</source>
        <translation>按装配顺序排列的条带</translation>
    </message>
    <message>
        <source>Later features that the cut parts do not contain</source>
        <translation>切割件中不包含的后续特征</translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation>在条带相交处开槽</translation>
    </message>
    <message>
        <source>Direction from which later strips are pushed on; zero for any direction</source>
        <translation>后装条带的推入方向；零表示任意</translation>
    </message>
    <message>
        <source>Number of joints of two slots</source>
        <translation>两槽相扣的接头数</translation>
    </message>
    <message>
        <source>Messages of the last recompute</source>
        <translation>上次重新计算的消息</translation>
    </message>
    <message>
        <source>Collisions of strips outside their slots, known a moment after the other results</source>
        <translation>条带在槽之外的碰撞，比其他结果稍后得出</translation>
    </message>
    <message>
        <source>Strip of this flat part</source>
        <translation>此平面件所属的条带</translation>
    </message>
    <message>
        <source>Layer of a laminated strip: base or backing</source>
        <translation>层压条带的层：基层或背层</translation>
    </message>
    <message>
        <source>Model whose slots the part gets; none for a single strip</source>
        <translation>零件采用其槽的模型；单独条带则不选</translation>
    </message>
    <message>
        <source>Sketch, or edges of an object, that the strip follows</source>
        <translation>条带所跟随的草图或对象的边</translation>
    </message>
    <message>
        <source>Shape of the feature: the strip as bent or as cut</source>
        <translation>特征的形状：弯曲后的条带或切割件</translation>
    </message>
    <message>
        <source>Material the strip is cut from</source>
        <translation>切割条带所用的材料</translation>
    </message>
    <message>
        <source>Full name of the sheet</source>
        <translation>板材的全名</translation>
    </message>
    <message>
        <source>Thickness of the sheet; measure yours</source>
        <translation>板材厚度；请实测</translation>
    </message>
    <message>
        <source>Data of the sheet, so that the file opens on every computer</source>
        <translation>板材数据，使文件可在任何电脑上打开</translation>
    </message>
    <message>
        <source>Compensate anticlastic bending in the widths if the sheet's Poisson ratio is known</source>
        <translation>若已知板材泊松比，则在宽度中补偿横向反弯</translation>
    </message>
    <message>
        <source>Compensate slots, narrow tabs and holes in the widths</source>
        <translation>在宽度中补偿槽、窄耳片和孔</translation>
    </message>
    <message>
        <source>Largest total width of ligaments or backing; 0 for the largest that fits</source>
        <translation>筋或背层的最大总宽度；0 表示可容纳的最大值</translation>
    </message>
    <message>
        <source>Style: plain, perforated or laminated</source>
        <translation>样式：普通、穿孔或层压</translation>
    </message>
    <message>
        <source>Sheet of the backing of a laminated strip</source>
        <translation>层压条带背层的板材</translation>
    </message>
    <message>
        <source>Data of the backing's sheet</source>
        <translation>背层板材的数据</translation>
    </message>
    <message>
        <source>Support at the start of the curve</source>
        <translation>曲线起点的支承</translation>
    </message>
    <message>
        <source>Support at the end of the curve</source>
        <translation>曲线终点的支承</translation>
    </message>
    <message>
        <source>Include the strip's own weight</source>
        <translation>计入条带自重</translation>
    </message>
    <message>
        <source>Direction of gravity in space</source>
        <translation>空间中的重力方向</translation>
    </message>
    <message>
        <source>Elasto-gravity length; 0 for the value of the sheet</source>
        <translation>弹性重力长度；0 表示采用板材的值</translation>
    </message>
    <message>
        <source>All weight in newtons: alpha = 0.001, own = true</source>
        <translation>全部重量（牛顿）：alpha = 0.001, own = true</translation>
    </message>
    <message>
        <source>Curvature of the strip before bending, 1/mm</source>
        <translation>弯曲前条带的曲率，1/mm</translation>
    </message>
    <message>
        <source>Curvature before bending that varies along the strip: stations = [0, 300], curvatures = [0, 0.01]</source>
        <translation>沿条带变化的预弯曲率：stations = [0, 300], curvatures = [0, 0.01]</translation>
    </message>
    <message>
        <source>Follow the curve exactly, or the nearest one within limits</source>
        <translation>精确跟随曲线，或跟随限制内最近的曲线</translation>
    </message>
    <message>
        <source>Least stability margin. A strip is stable above 0, and safely stable from 5.</source>
        <translation>最小稳定裕度。大于 0 时条带稳定，达到 5 时足够安全。</translation>
    </message>
    <message>
        <source>Largest strain in percent; 0 for the limit of the sheet</source>
        <translation>最大应变（%）；0 表示采用板材极限</translation>
    </message>
    <message>
        <source>Apply the strain limit</source>
        <translation>应用应变极限</translation>
    </message>
    <message>
        <source>Largest length; 0 for no limits</source>
        <translation>最大长度；0 表示不限</translation>
    </message>
    <message>
        <source>Largest width, which bounds the ratio; 0 for none</source>
        <translation>限制刚度比的最大宽度；0 表示无</translation>
    </message>
    <message>
        <source>Ends that keep their position</source>
        <translation>保持位置的端点</translation>
    </message>
    <message>
        <source>Keep the tangents of both ends</source>
        <translation>保持两端切线</translation>
    </message>
    <message>
        <source>Keep inflections on the curve's inflection line</source>
        <translation>拐点保持在曲线的拐点线上</translation>
    </message>
    <message>
        <source>Two points of another line: x, y, x, y</source>
        <translation>另一条线上的两点：x, y, x, y</translation>
    </message>
    <message>
        <source>Length of the tab at the start</source>
        <translation>起点耳片长度</translation>
    </message>
    <message>
        <source>Length of the tab at the end</source>
        <translation>终点耳片长度</translation>
    </message>
    <message>
        <source>Rounding of the tabs' corners</source>
        <translation>耳片圆角</translation>
    </message>
    <message>
        <source>Diameter of a hole in the middle of each tab; 0 for none</source>
        <translation>每个耳片中央孔的直径；0 表示无</translation>
    </message>
    <message>
        <source>The first tab in full: length = 12, chamfer = 2</source>
        <translation>起点耳片的完整参数：length = 12, chamfer = 2</translation>
    </message>
    <message>
        <source>The last tab in full</source>
        <translation>终点耳片的完整参数</translation>
    </message>
    <message>
        <source>Number of copies to cut</source>
        <translation>切割份数</translation>
    </message>
    <message>
        <source>Verdict on the strip and its curve</source>
        <translation>对条带及其曲线的判定</translation>
    </message>
    <message>
        <source>Reasons and remarks</source>
        <translation>原因和提示</translation>
    </message>
    <message>
        <source>Results that make the strip fail</source>
        <translation>使条带失效的结果</translation>
    </message>
    <message>
        <source>Largest stiffness over least stiffness</source>
        <translation>最大刚度与最小刚度之比</translation>
    </message>
    <message>
        <source>Stability margin; positive means stable</source>
        <translation>稳定裕度；为正表示稳定</translation>
    </message>
    <message>
        <source>Place along the strip where stability is lost; 0 for a stable strip</source>
        <translation>条带上失稳的位置；稳定时为 0</translation>
    </message>
    <message>
        <source>Largest strain, in percent of the sheet's limit</source>
        <translation>最大应变，占板材极限的百分比</translation>
    </message>
    <message>
        <source>Largest strain of the skin, in percent</source>
        <translation>表层最大应变（百分比）</translation>
    </message>
    <message>
        <source>Largest distance from the drawn curve</source>
        <translation>与所绘曲线的最大距离</translation>
    </message>
    <message>
        <source>Length of the free part along the curve</source>
        <translation>沿曲线自由部分的长度</translation>
    </message>
    <message>
        <source>Width of the narrowest place</source>
        <translation>最窄处的宽度</translation>
    </message>
    <message>
        <source>Mass in grams</source>
        <translation>质量（克）</translation>
    </message>
    <message>
        <source>Hidden because its recompute failed</source>
        <translation>因重新计算失败而隐藏</translation>
    </message>
    <message>
        <source>Shown because the recompute of its model failed</source>
        <translation>因其模型重新计算失败而显示</translation>
    </message>
    <message>
        <source>Identifies the request from which the shape was made</source>
        <translation>标识生成形状的请求</translation>
    </message>
    <message>
        <source>Objects with which the curve moves</source>
        <translation>曲线随之移动的对象</translation>
    </message>
    <message>
        <source>Model or strips whose tabs go through the plate</source>
        <translation>耳片穿过此板的模型或条带</translation>
    </message>
    <message>
        <source>Sheet of the plate</source>
        <translation>底板的板材</translation>
    </message>
    <message>
        <source>Data of the sheet</source>
        <translation>板材数据</translation>
    </message>
    <message>
        <source>Model or strips whose ends are held</source>
        <translation>端部被固定的模型或条带</translation>
    </message>
    <message>
        <source>Strips, models and base plates to be cut</source>
        <translation>要切割的条带、模型和底板</translation>
    </message>
    <message>
        <source>Width of a sheet, along its grain</source>
        <translation>板材宽度（沿纹理）</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>板材高度</translation>
    </message>
    <message>
        <source>Smallest distance between parts, and from the edge</source>
        <translation>零件之间及到边缘的最小距离</translation>
    </message>
    <message>
        <source>Number of sheets</source>
        <translation>所需板材数</translation>
    </message>
    <message>
        <source>Show live feedback while this sketch is open</source>
        <translation>打开此草图时显示实时反馈</translation>
    </message>
    <message>
        <source>Angle over which half planes are spread</source>
        <translation>半平面分布的角度</translation>
    </message>
    <message>
        <source>Bodies, surfaces and meshes that are cut</source>
        <translation>被切割的实体、曲面和网格</translation>
    </message>
    <message>
        <source>Largest distance of a curve from the section</source>
        <translation>曲线与截面的最大距离</translation>
    </message>
    <message>
        <source>Largest displacement of the curve</source>
        <translation>曲线的最大位移</translation>
    </message>
    <message>
        <source>Displacement of the end along x</source>
        <translation>终点沿 x 的位移</translation>
    </message>
    <message>
        <source>Displacement of the end along y</source>
        <translation>终点沿 y 的位移</translation>
    </message>
    <message>
        <source>Rotation of the end</source>
        <translation>终点的转角</translation>
    </message>
    <message>
        <source>Displacement of the start along x</source>
        <translation>起点沿 x 的位移</translation>
    </message>
    <message>
        <source>Displacement of the start along y</source>
        <translation>起点沿 y 的位移</translation>
    </message>
    <message>
        <source>Rotation of the start</source>
        <translation>起点的转角</translation>
    </message>
    <message>
        <source>Number of curves</source>
        <translation>曲线数</translation>
    </message>
    <message>
        <source>Number of planes</source>
        <translation>平面数</translation>
    </message>
    <message>
        <source>Arrangement of the planes</source>
        <translation>平面的排列</translation>
    </message>
    <message>
        <source>Sketch, wire or edges perpendicular to the planes</source>
        <translation>与平面垂直的草图、线框或边</translation>
    </message>
    <message>
        <source>Point on the axis of half planes: x</source>
        <translation>半平面轴上的点：x</translation>
    </message>
    <message>
        <source>Point on the axis of half planes: y</source>
        <translation>半平面轴上的点：y</translation>
    </message>
    <message>
        <source>Point on the axis of half planes: z</source>
        <translation>半平面轴上的点：z</translation>
    </message>
    <message>
        <source>Strip to bend</source>
        <translation>要弯曲的条带</translation>
    </message>
    <message>
        <source>Shortest wavelength that is kept; 0 keeps all waves</source>
        <translation>保留的最短波长；0 表示全部保留</translation>
    </message>
    <message>
        <source>Treatment of closed lines</source>
        <translation>闭合线的处理</translation>
    </message>
    <message>
        <source>Axis perpendicular to the planes, or common to the half planes</source>
        <translation>垂直于平面的轴，或半平面的公共轴</translation>
    </message>
    <message>
        <source>Sideways stability margin; positive means stable, 0 undecided</source>
        <translation>侧向稳定裕度；为正表示稳定，0 表示未定</translation>
    </message>
    <message>
        <source>Sideways stability</source>
        <translation>侧向稳定性</translation>
    </message>
    <message>
        <source>Model or strips whose tabs go through the rings</source>
        <translation>耳片穿过圆环的模型或条带</translation>
    </message>
    <message>
        <source>Sheet of the rings</source>
        <translation>圆环的板材</translation>
    </message>
    <message>
        <source>Ends of the strips that have a ring</source>
        <translation>条带的哪些端有圆环</translation>
    </message>
    <message>
        <source>Distance between two rings that hold inclined tabs at their angle; 0 for one ring at each end</source>
        <translation>两个圆环之间的距离，使倾斜的耳片保持角度；0 表示每端一个圆环</translation>
    </message>
    <message>
        <source>Masses and forces on the strip: at = 90, mass = 3, or at = 90, force = [0, -1] (mm, g, N)</source>
        <translation>条带上的质量和力：at = 90, mass = 3，或 at = 90, force = [0, -1]（mm、g、N）</translation>
    </message>
    <message>
        <source>Sketch or edges with the first state</source>
        <translation>第一状态的草图或边</translation>
    </message>
    <message>
        <source>Sketch or edges with the second state</source>
        <translation>第二状态的草图或边</translation>
    </message>
    <message>
        <source>What the feature shows</source>
        <translation>对象显示的内容</translation>
    </message>
    <message>
        <source>Material the part is cut from</source>
        <translation>切割零件所用的材料</translation>
    </message>
    <message>
        <source>Verdict on the part and its curves</source>
        <translation>对零件及其曲线的判定</translation>
    </message>
    <message>
        <source>True if the part snaps between its states in the same clamps</source>
        <translation>若零件在相同夹持下于两状态间突跳则为真</translation>
    </message>
    <message>
        <source>Largest force between the states, N</source>
        <translation>两状态之间的最大力，N</translation>
    </message>
    <message>
        <source>Travel of the pushed point at which the part snaps; 0 for none</source>
        <translation>零件突跳时受推点的行程；0 表示无</translation>
    </message>
    <message>
        <source>Length between the pads along the curve</source>
        <translation>两端块之间沿曲线的长度</translation>
    </message>
    <message>
        <source>Least thickness in the plane</source>
        <translation>平面内的最小厚度</translation>
    </message>
    <message>
        <source>Largest thickness in the plane</source>
        <translation>平面内的最大厚度</translation>
    </message>
    <message>
        <source>Largest gap between ends of edges that is closed</source>
        <translation>可闭合的边端点之间的最大间隙</translation>
    </message>
    <message>
        <source>Messages in all languages</source>
        <translation>各语言的消息</translation>
    </message>
    <message>
        <source>Keep the curve as drawn, if it is not smoothed</source>
        <translation>未平滑时保持所绘曲线</translation>
    </message>
    <message>
        <source>Apply the least stability margin</source>
        <translation>应用最小稳定裕度</translation>
    </message>
    <message>
        <source>Smallest length; applies together with the largest length</source>
        <translation>最小长度；与最大长度一起生效</translation>
    </message>
    <message>
        <source>Ends whose tangents are kept</source>
        <translation>保持切线的端点</translation>
    </message>
    <message>
        <source>Length of the curve to which the places of rails, ties and loads refer; 0 for the present length</source>
        <translation>导轨、拉绳和载荷位置所参照的曲线长度；0 表示当前长度</translation>
    </message>
    <message>
        <source>Sources in the same container; they enter and leave containers together with the feature</source>
        <translation>同一容器中的来源；它们与该特征一起移入和移出容器</translation>
    </message>
    <message>
        <source>Lengths and ends of the edges when they were chosen</source>
        <translation>选择边时的长度和端点</translation>
    </message>
</context>
<context>
    <name>Elastica</name>
    <message>
        <source>en</source>
        <translation>zh-CN</translation>
    </message>
    <message>
        <source>Pull the ends and the tangents by their handles; the curve is drawn on release</source>
        <translation>用手柄拖动端点和切线；松开时绘制曲线</translation>
    </message>
    <message>
        <source>Length between the clamps</source>
        <translation>夹具之间的长度</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>另一侧</translation>
    </message>
    <message>
        <source>Save the coupon</source>
        <translation>保存试样</translation>
    </message>
    <message>
        <source>type the readings first: overhang = droop, in mm, such as 120 = 14.5; 150 = 31</source>
        <translation>请先输入读数：悬伸 = 下垂（mm），例如 120 = 14.5; 150 = 31</translation>
    </message>
    <message>
        <source>Longest overhang of the coupon</source>
        <translation>试样最大悬伸</translation>
    </message>
    <message>
        <source>wrote</source>
        <translation>已写出</translation>
    </message>
    <message>
        <source>kept as</source>
        <translation>已存为</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>文件所在文件夹</translation>
    </message>
    <message>
        <source>DXF files are of version R12 here, curves as arcs: the library ezdxf is missing.</source>
        <translation>此处 DXF 文件为 R12 版本，曲线写为圆弧：缺少库 ezdxf。</translation>
    </message>
    <message>
        <source>The files do not contain {later}, which was added after {strip}. Add it to the strip (slots, tabs, holes), or draw it in the files.</source>
        <translation>文件不包含在 {strip} 之后添加的 {later}。请在条带中添加（槽、耳片、孔），或画入文件。</translation>
    </message>
    <message>
        <source>choose a folder for the files</source>
        <translation>请选择文件夹</translation>
    </message>
    <message>
        <source>exists already: choose another folder, or tick the box that overwrites</source>
        <translation>已存在：请选择另一个文件夹，或勾选覆盖已有文件</translation>
    </message>
    <message>
        <source>Enter the full path of the folder, or press Browse.</source>
        <translation>请输入文件夹的完整路径，或按“浏览”。</translation>
    </message>
    <message>
        <source>Ranges are those of the sheet.</source>
        <translation>范围取自板材。</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>The edited object was deleted. Press Cancel.</source>
        <translation>所编辑的对象已被删除。请按“取消”。</translation>
    </message>
    <message>
        <source>Use the nearest curve</source>
        <translation>使用最近的曲线</translation>
    </message>
    <message>
        <source>Pick another curve</source>
        <translation>选择其他曲线</translation>
    </message>
    <message>
        <source>Then click a sketch or an edge, in the view or in the tree</source>
        <translation>然后在视图或树中点击草图或边</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Move or turn an end: type numbers, or drag one of the handles in the view.</source>
        <translation>移动或旋转端部：输入数值，或在视图中拖动一个手柄。</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>条带</translation>
    </message>
    <message>
        <source>bent further</source>
        <translation>继续弯曲</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>条带</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Flat part</source>
        <translation>平面件</translation>
    </message>
    <message>
        <source>End fixtures</source>
        <translation>端部夹具</translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation>底板</translation>
    </message>
    <message>
        <source>Nest on sheets</source>
        <translation>在板材上排样</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>刚度比</translation>
    </message>
    <message>
        <source>Sheet and width</source>
        <translation>板材与宽度</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>样式</translation>
    </message>
    <message>
        <source>Nearest curve</source>
        <translation>最近曲线</translation>
    </message>
    <message>
        <source>Ends and weight</source>
        <translation>端部与重量</translation>
    </message>
    <message>
        <source>Slots</source>
        <translation>槽</translation>
    </message>
    <message>
        <source>Printed blocks</source>
        <translation>打印夹具</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Largest width</source>
        <translation>最大宽度</translation>
    </message>
    <message>
        <source>Least width</source>
        <translation>最小宽度</translation>
    </message>
    <message>
        <source>Outer width</source>
        <translation>外宽</translation>
    </message>
    <message>
        <source>Columns of holes</source>
        <translation>孔列数</translation>
    </message>
    <message>
        <source>Rows of holes (0 = automatic)</source>
        <translation>孔行数（0 = 自动）</translation>
    </message>
    <message>
        <source>Backing</source>
        <translation>背层</translation>
    </message>
    <message>
        <source>Shape shown</source>
        <translation>显示的形状</translation>
    </message>
    <message>
        <source>Follow the curve</source>
        <translation>跟随曲线</translation>
    </message>
    <message>
        <source>Largest stiffness ratio</source>
        <translation>最大刚度比</translation>
    </message>
    <message>
        <source>Least stability margin</source>
        <translation>最小稳定裕度</translation>
    </message>
    <message>
        <source>Largest strain, % (0 = sheet)</source>
        <translation>最大应变，%（0 = 板材）</translation>
    </message>
    <message>
        <source>Keep end tangents</source>
        <translation>保持端点切线</translation>
    </message>
    <message>
        <source>Keep the length</source>
        <translation>保持长度</translation>
    </message>
    <message>
        <source>Start is held</source>
        <translation>起点约束</translation>
    </message>
    <message>
        <source>End is held</source>
        <translation>终点约束</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>自重</translation>
    </message>
    <message>
        <source>Tab at the start</source>
        <translation>起点耳片</translation>
    </message>
    <message>
        <source>Tab at the end</source>
        <translation>终点耳片</translation>
    </message>
    <message>
        <source>Rounding of tabs</source>
        <translation>耳片圆角</translation>
    </message>
    <message>
        <source>Hole in tabs</source>
        <translation>耳片孔</translation>
    </message>
    <message>
        <source>Engraved text</source>
        <translation>雕刻文字</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation>在条带相交处开槽</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Width of slots</source>
        <translation>槽宽</translation>
    </message>
    <message>
        <source>Inner ends of slots</source>
        <translation>槽的内端</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>层</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁厚</translation>
    </message>
    <message>
        <source>Foot (0 = none)</source>
        <translation>底脚（0 = 无）</translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation>底脚高度</translation>
    </message>
    <message>
        <source>Screw holes (0 = none)</source>
        <translation>螺钉孔（0 = 无）</translation>
    </message>
    <message>
        <source>Play beside tabs</source>
        <translation>耳片旁间隙</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Sheet width</source>
        <translation>板材宽度</translation>
    </message>
    <message>
        <source>Sheet height</source>
        <translation>板材高度</translation>
    </message>
    <message>
        <source>Distance between parts</source>
        <translation>零件间距</translation>
    </message>
    <message>
        <source>Built-in sheets stay: keep yours under another name.</source>
        <translation>内置板材不可删除：请用其他名称保存。</translation>
    </message>
    <message>
        <source>least radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>elasto-gravity length</source>
        <translation>弹性重力长度</translation>
    </message>
    <message>
        <source>Constraints on the drawn curve that OK takes away</source>
        <translation>点击确定后将移除的曲线约束</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>最大距离</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>Written to</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>curvature</source>
        <translation>曲率</translation>
    </message>
    <message>
        <source>stiffness range</source>
        <translation>刚度范围</translation>
    </message>
    <message>
        <source>thickness along the strip</source>
        <translation>沿条带的厚度</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>自重</translation>
    </message>
    <message>
        <source>end angles</source>
        <translation>端部角度</translation>
    </message>
    <message>
        <source>plasticity</source>
        <translation>塑性</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>kerf</source>
        <translation>切缝</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>刚度比</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>稳定裕度</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation>禁入区域</translation>
    </message>
    <message>
        <source>stiffness bounds</source>
        <translation>刚度界限</translation>
    </message>
    <message>
        <source>end position</source>
        <translation>终点位置</translation>
    </message>
    <message>
        <source>end tangent</source>
        <translation>终点切线</translation>
    </message>
    <message>
        <source>start position</source>
        <translation>起点位置</translation>
    </message>
    <message>
        <source>start tangent</source>
        <translation>起点切线</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>inflection line</source>
        <translation>拐点线</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>the strip laid flat</source>
        <translation>展平的条带</translation>
    </message>
    <message>
        <source>can</source>
        <translation>可以</translation>
    </message>
    <message>
        <source>no curve yet</source>
        <translation>尚无曲线</translation>
    </message>
    <message>
        <source>Select a sketch with a spline, or an edge of an object, first.</source>
        <translation>请先选择带样条的草图或对象的边。</translation>
    </message>
    <message>
        <source>Select a sketch with a spline first.</source>
        <translation>请先选择带样条的草图。</translation>
    </message>
    <message>
        <source>Select a strip first.</source>
        <translation>请先选择一个条带。</translation>
    </message>
    <message>
        <source>Select two strips or more first.</source>
        <translation>请先选择两个或更多条带。</translation>
    </message>
    <message>
        <source>The selected lines are pieces of a polyline, as FreeCAD reads it from a file: draw a B-spline through their ends (workbench Draft) and select that.</source>
        <translation>所选直线是一条折线的各段（FreeCAD 从文件中如此读入）：请过其端点画一条 B 样条（Draft 工作台）并选择它。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Axis at x</source>
        <translation>轴的 x</translation>
    </message>
    <message>
        <source>Axis at y</source>
        <translation>轴的 y</translation>
    </message>
    <message>
        <source>Axis at z</source>
        <translation>轴的 z</translation>
    </message>
    <message>
        <source>Closed lines</source>
        <translation>闭合线</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Draw it into the sketch</source>
        <translation>绘入草图</translation>
    </message>
    <message>
        <source>Escape stops it</source>
        <translation>按 Esc 停止</translation>
    </message>
    <message>
        <source>Writing files</source>
        <translation>正在写文件</translation>
    </message>
    <message>
        <source>Searching for changes that help</source>
        <translation>正在查找有效的修改</translation>
    </message>
    <message>
        <source>Keep it possible</source>
        <translation>保持可制作</translation>
    </message>
    <message>
        <source>A dragged pole returns to the last position where the strip can be made</source>
        <translation>被拖动的控制点会退回到条带仍可制作的最后位置</translation>
    </message>
    <message>
        <source>The cutting files show {strip} without {later}, a later feature of its body. Use the slots, tabs and holes of the strip instead, or draw the change in the files.</source>
        <translation>切割文件中的 {strip} 不含 {later}，即其实体的后续特征。请改用条带自身的槽、耳片和孔，或将更改画入文件。</translation>
    </message>
    <message>
        <source>Searching the nearest curve</source>
        <translation>正在搜索最近曲线</translation>
    </message>
    <message>
        <source>Putting the model together</source>
        <translation>正在组合模型</translation>
    </message>
    <message>
        <source>Making the blocks</source>
        <translation>正在生成夹具</translation>
    </message>
    <message>
        <source>Looking for strips that meet</source>
        <translation>正在查找相碰的条带</translation>
    </message>
    <message>
        <source>Cutting the mesh</source>
        <translation>正在剖切网格</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>正在剖切</translation>
    </message>
    <message>
        <source>Bending the strip</source>
        <translation>正在弯曲条带</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Keep the ends</source>
        <translation>保持端点</translation>
    </message>
    <message>
        <source>Keep the symmetry</source>
        <translation>保持对称</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限制</translation>
    </message>
    <message>
        <source>Must not break</source>
        <translation>不得断裂</translation>
    </message>
    <message>
        <source>Must be stable</source>
        <translation>必须稳定</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Section into curves</source>
        <translation>截切成曲线</translation>
    </message>
    <message>
        <source>Keep the curve as drawn</source>
        <translation>保持所绘曲线</translation>
    </message>
    <message>
        <source>Smooth the curve by</source>
        <translation>曲线光顺量</translation>
    </message>
    <message>
        <source>Smooth waves below</source>
        <translation>抹平短于此值的波纹</translation>
    </message>
    <message>
        <source>Spread over</source>
        <translation>分布角度</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>sketch</source>
        <translation>草图</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>平行</translation>
    </message>
    <message>
        <source>about an axis</source>
        <translation>绕轴</translation>
    </message>
    <message>
        <source>along a path</source>
        <translation>沿路径</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>舍去</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>左右两半</translation>
    </message>
    <message>
        <source>above and below</source>
        <translation>上下两半</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>弯曲</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>Perforated</source>
        <translation>穿孔</translation>
    </message>
    <message>
        <source>Laminated</source>
        <translation>层压</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>最近曲线</translation>
    </message>
    <message>
        <source>clamped</source>
        <translation>夹紧</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>铰接</translation>
    </message>
    <message>
        <source>slide-x</source>
        <translation>沿 x 滑动</translation>
    </message>
    <message>
        <source>slide-y</source>
        <translation>沿 y 滑动</translation>
    </message>
    <message>
        <source>roller-x</source>
        <translation>可转动，沿 x 滑动</translation>
    </message>
    <message>
        <source>roller-y</source>
        <translation>可转动，沿 y 滑动</translation>
    </message>
    <message>
        <source>guided</source>
        <translation>导向</translation>
    </message>
    <message>
        <source>free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>spline</source>
        <translation>样条</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>bezier</source>
        <translation>贝塞尔</translation>
    </message>
    <message>
        <source>polyline</source>
        <translation>折线</translation>
    </message>
    <message>
        <source>both</source>
        <translation>两端</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>end</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>按论文</translation>
    </message>
    <message>
        <source>square</source>
        <translation>方形</translation>
    </message>
    <message>
        <source>round</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基层</translation>
    </message>
    <message>
        <source>hull</source>
        <translation>凸包</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Make a sketch to edit</source>
        <translation>生成可编辑的草图</translation>
    </message>
    <message>
        <source>Make sketches to edit</source>
        <translation>生成可编辑的草图</translation>
    </message>
    <message>
        <source>Replaces this feature by objects that no longer follow its source</source>
        <translation>用不再跟随来源的对象替换此特征</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>backing</source>
        <translation>背层</translation>
    </message>
    <message>
        <source>inflection on the line</source>
        <translation>拐点在直线上</translation>
    </message>
    <message>
        <source>inflection off it</source>
        <translation>拐点偏离直线</translation>
    </message>
    <message>
        <source>nearest curve</source>
        <translation>最近的曲线</translation>
    </message>
    <message>
        <source>above the sheet's limit</source>
        <translation>超过板材极限</translation>
    </message>
    <message>
        <source>the line must not meet the curve here</source>
        <translation>直线不得在此与曲线相交</translation>
    </message>
    <message>
        <source>Select blocks, a plate or rings.</source>
        <translation>请选择夹具、底板或圆环。</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Ends held</source>
        <translation>固定的端</translation>
    </message>
    <message>
        <source>Gap (0 = one ring)</source>
        <translation>间距（0 = 一个圆环）</translation>
    </message>
    <message>
        <source>Rail (bar on one side)</source>
        <translation>支承杆（单侧）</translation>
    </message>
    <message>
        <source>Slot (two bars)</source>
        <translation>槽（双侧杆）</translation>
    </message>
    <message>
        <source>Pin (the strip turns)</source>
        <translation>销（条带可转动）</translation>
    </message>
    <message>
        <source>Tie (cord)</source>
        <translation>拉索</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Hung mass</source>
        <translation>悬挂质量</translation>
    </message>
    <message>
        <source>Click the other end of the cord.</source>
        <translation>单击拉索的另一端。</translation>
    </message>
    <message>
        <source>Click the place on the sketch or on the strip.</source>
        <translation>单击草图或条带上的位置。</translation>
    </message>
    <message>
        <source>thrust line</source>
        <translation>推力线</translation>
    </message>
    <message>
        <source>cord</source>
        <translation>拉索</translation>
    </message>
    <message>
        <source>rail, pin, tie or load</source>
        <translation>支承杆、销、拉索或载荷</translation>
    </message>
    <message>
        <source>Two-state part</source>
        <translation>双状态零件</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>First state</source>
        <translation>第一状态</translation>
    </message>
    <message>
        <source>Second state</source>
        <translation>第二状态</translation>
    </message>
    <message>
        <source>As cut</source>
        <translation>切割形状</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>支座</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>支座</translation>
    </message>
    <message>
        <source>two states</source>
        <translation>两状态</translation>
    </message>
    <message>
        <source>Searching the part with two states</source>
        <translation>正在搜索双状态零件</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Radius at the pads</source>
        <translation>端块处半径</translation>
    </message>
    <message>
        <source>State without forces</source>
        <translation>无力状态</translation>
    </message>
    <message>
        <source>Thinnest place (0 = automatic)</source>
        <translation>最薄处（0 = 自动）</translation>
    </message>
    <message>
        <source>Equal lengths: keep</source>
        <translation>等长：保持</translation>
    </message>
    <message>
        <source>Largest thickness or least ratio</source>
        <translation>最大厚度或最小比值</translation>
    </message>
    <message>
        <source>Holes in pads</source>
        <translation>端块上的孔</translation>
    </message>
    <message>
        <source>Holes from the ends of pads</source>
        <translation>孔距端块末端</translation>
    </message>
    <message>
        <source>Length of pads</source>
        <translation>端块长度</translation>
    </message>
    <message>
        <source>Width of pads</source>
        <translation>端块宽度</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>打印</translation>
    </message>
    <message>
        <source>Pushed at (0 = middle)</source>
        <translation>受推位置（0 = 中点）</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>端点</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>first</source>
        <translation>第一</translation>
    </message>
    <message>
        <source>second</source>
        <translation>第二</translation>
    </message>
    <message>
        <source>Every selected strip has its flat part.</source>
        <translation>所选条带均已有平面件。</translation>
    </message>
    <message>
        <source>First draw a single curve.</source>
        <translation>请先绘制单条曲线。</translation>
    </message>
    <message>
        <source>First use the nearest curve.</source>
        <translation>请先使用最近的曲线。</translation>
    </message>
    <message>
        <source>First make the strip possible.</source>
        <translation>请先使条带可行。</translation>
    </message>
    <message>
        <source>Make it anyway</source>
        <translation>仍然制作</translation>
    </message>
    <message>
        <source>Height of its upper face</source>
        <translation>上表面高度</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>切缝</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>缺口</translation>
    </message>
    <message>
        <source>Nearest curve to sketch</source>
        <translation>草图的最近曲线</translation>
    </message>
    <message>
        <source>Follow the curve: Nearest</source>
        <translation>跟随曲线: 最近曲线</translation>
    </message>
    <message>
        <source>flat outline</source>
        <translation>平面轮廓</translation>
    </message>
    <message>
        <source>backing outline</source>
        <translation>背层轮廓</translation>
    </message>
    <message>
        <source>Every selected strip has its outline.</source>
        <translation>所选条带均已有轮廓。</translation>
    </message>
</context>
<context>
    <name>ElasticaBend</name>
    <message>
        <source>Bend forward</source>
        <translation>继续弯曲</translation>
    </message>
    <message>
        <source>Start of the strip</source>
        <translation>条带起点</translation>
    </message>
    <message>
        <source>Move x</source>
        <translation>x 向位移</translation>
    </message>
    <message>
        <source>Move y</source>
        <translation>y 向位移</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>End of the strip</source>
        <translation>条带终点</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Displacement of the start along x</source>
        <translation>起点沿 x 的位移</translation>
    </message>
    <message>
        <source>Displacement of the start along y</source>
        <translation>起点沿 y 的位移</translation>
    </message>
    <message>
        <source>Rotation of the start, degrees</source>
        <translation>起点的转角（度）</translation>
    </message>
    <message>
        <source>Displacement of the end along x</source>
        <translation>终点沿 x 的位移</translation>
    </message>
    <message>
        <source>Displacement of the end along y</source>
        <translation>终点沿 y 的位移</translation>
    </message>
    <message>
        <source>Rotation of the end, degrees</source>
        <translation>终点的转角（度）</translation>
    </message>
    <message>
        <source>Show the path from rest in small steps</source>
        <translation>逐步显示从静止位置开始的过程</translation>
    </message>
</context>
<context>
    <name>ElasticaCheck</name>
    <message>
        <source>Check curve</source>
        <translation>检查曲线</translation>
    </message>
</context>
<context>
    <name>ElasticaCoupon</name>
    <message>
        <source>Coupon and calibrate</source>
        <translation>试样与标定</translation>
    </message>
    <message>
        <source>Coupon</source>
        <translation>试样</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Make the coupon</source>
        <translation>生成试样</translation>
    </message>
    <message>
        <source>Write its cutting file</source>
        <translation>写出切割文件</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Overhang = droop, mm</source>
        <translation>悬伸 = 下垂，mm</translation>
    </message>
    <message>
        <source>120 = 14.5; 150 = 31</source>
        <translation>120 = 14.5; 150 = 31</translation>
    </message>
    <message>
        <source>Reading error</source>
        <translation>读数误差</translation>
    </message>
    <message>
        <source>Name of the sheet</source>
        <translation>板材名称</translation>
    </message>
    <message>
        <source>Keep the sheet</source>
        <translation>保存板材</translation>
    </message>
    <message>
        <source>Sheet to be measured</source>
        <translation>要测量的板材</translation>
    </message>
    <message>
        <source>Adds the test strip to the document</source>
        <translation>把试样加入文档</translation>
    </message>
    <message>
        <source>Asks for a DXF or SVG file and writes the test strip into it</source>
        <translation>选择 DXF 或 SVG 文件并写入试样</translation>
    </message>
    <message>
        <source>Overhang = droop, in mm, one pair for each measurement</source>
        <translation>悬伸 = 下垂（mm），每次测量一对</translation>
    </message>
    <message>
        <source>Uncertainty of a reading</source>
        <translation>读数的误差</translation>
    </message>
    <message>
        <source>Name of the calibrated sheet in your library</source>
        <translation>标定后的板材在库中的名称</translation>
    </message>
    <message>
        <source>Adds the calibrated sheet to your library</source>
        <translation>把标定后的板材加入库</translation>
    </message>
</context>
<context>
    <name>ElasticaExport</name>
    <message>
        <source>Export cutting files</source>
        <translation>导出切割文件</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>DXF</source>
        <translation>DXF</translation>
    </message>
    <message>
        <source>SVG</source>
        <translation>SVG</translation>
    </message>
    <message>
        <source>STEP, flat and bent</source>
        <translation>STEP，平展与弯曲</translation>
    </message>
    <message>
        <source>Cut list (CSV)</source>
        <translation>下料清单 (CSV)</translation>
    </message>
    <message>
        <source>Nest on sheets</source>
        <translation>在板材上排样</translation>
    </message>
    <message>
        <source>Sheet width</source>
        <translation>板材宽度</translation>
    </message>
    <message>
        <source>Sheet height</source>
        <translation>板材高度</translation>
    </message>
    <message>
        <source>How</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>DXF version</source>
        <translation>DXF 版本</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>切缝</translation>
    </message>
    <message>
        <source>Tolerance of arcs and polylines</source>
        <translation>圆弧和折线公差</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>Overwrite files that exist</source>
        <translation>覆盖已有文件</translation>
    </message>
    <message>
        <source>One drawing for each part, for lasers and cutters</source>
        <translation>每个零件一张图，用于激光和切割机</translation>
    </message>
    <message>
        <source>The same drawings for programs that draw</source>
        <translation>供绘图软件使用的同样图形</translation>
    </message>
    <message>
        <source>Solids for other CAD programs</source>
        <translation>供其他 CAD 软件使用的实体</translation>
    </message>
    <message>
        <source>A table of all parts with sizes and numbers</source>
        <translation>列出所有零件的尺寸和数量</translation>
    </message>
    <message>
        <source>All parts together on sheets</source>
        <translation>把所有零件排到板材上</translation>
    </message>
    <message>
        <source>Width of a sheet, along its grain</source>
        <translation>板材宽度，沿纹理方向</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>板材高度</translation>
    </message>
    <message>
        <source>Splines as drawn, or arcs or lines for machines that take nothing else</source>
        <translation>按所绘样条，或为只接受圆弧或直线的机器转换</translation>
    </message>
    <message>
        <source>The oldest version that your program reads is the safest</source>
        <translation>您的程序能读取的最旧版本最稳妥</translation>
    </message>
    <message>
        <source>Width removed by the cut; outlines are offset by half of it</source>
        <translation>切割去除的宽度；轮廓偏移其一半</translation>
    </message>
    <message>
        <source>Largest distance of arcs and lines from the spline</source>
        <translation>圆弧和直线与样条的最大距离</translation>
    </message>
    <message>
        <source>Machines that cut every line would cut the tabs off at their guide lines</source>
        <translation>会切割每条线的机器将在辅助线处把耳片切断</translation>
    </message>
    <message>
        <source>Guide lines and names of mating strips</source>
        <translation>辅助线和配合条带的名称</translation>
    </message>
    <message>
        <source>Folder of the files; an empty field opens a dialog</source>
        <translation>文件所在文件夹；留空则弹出对话框</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>If this is off, existing files are not changed</source>
        <translation>不勾选则不更改已有文件</translation>
    </message>
</context>
<context>
    <name>ElasticaFixtures</name>
    <message>
        <source>End fixtures and base plate</source>
        <translation>端部夹具与底板</translation>
    </message>
    <message>
        <source>Printed blocks</source>
        <translation>打印夹具</translation>
    </message>
    <message>
        <source>Make blocks for the ends</source>
        <translation>为端部生成夹具</translation>
    </message>
    <message>
        <source>Room around the tab</source>
        <translation>耳片周围间隙</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁厚</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>底脚</translation>
    </message>
    <message>
        <source>Screw holes</source>
        <translation>螺钉孔</translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation>底板</translation>
    </message>
    <message>
        <source>Make a slotted plate</source>
        <translation>生成开槽板</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Height of its upper face</source>
        <translation>上表面高度</translation>
    </message>
    <message>
        <source>Room beside the tab</source>
        <translation>耳片两侧间隙</translation>
    </message>
    <message>
        <source>Clearance of slots</source>
        <translation>槽间隙</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>Blocks to be printed, with a pocket for every tab</source>
        <translation>可打印的夹具，每个耳片有一个槽腔</translation>
    </message>
    <message>
        <source>Room around a tab in its pocket</source>
        <translation>耳片在槽腔中的间隙</translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation>槽腔周围的最小壁厚</translation>
    </message>
    <message>
        <source>Width of the foot on either side; 0 for none</source>
        <translation>底脚每侧的宽度；0 表示无</translation>
    </message>
    <message>
        <source>Diameter of the screw holes in the foot; 0 for none</source>
        <translation>底脚螺钉孔直径；0 表示无</translation>
    </message>
    <message>
        <source>One plate with a slot for every tab that goes through it</source>
        <translation>一块底板，每个穿过的耳片有一个槽</translation>
    </message>
    <message>
        <source>Sheet of the plate</source>
        <translation>底板的板材</translation>
    </message>
    <message>
        <source>Position of the upper face of the plate along z</source>
        <translation>板上表面沿 z 的位置</translation>
    </message>
    <message>
        <source>Room beside a tab on either side</source>
        <translation>耳片两侧的间隙</translation>
    </message>
    <message>
        <source>Added to the width of the slots</source>
        <translation>槽宽的附加量</translation>
    </message>
    <message>
        <source>Least distance of the slots for strips from the edge</source>
        <translation>条带的槽到边缘的最小距离</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>One ring with a slot for every tab at the start of the strips, and one for the ends, such as below and above a lamp</source>
        <translation>一个圆环为条带起点的每个耳片开槽，另一个用于终点，例如灯的下方和上方</translation>
    </message>
    <message>
        <source>Make a ring for each end</source>
        <translation>为每端制作一个圆环</translation>
    </message>
    <message>
        <source>Sheet of the rings</source>
        <translation>圆环的板材</translation>
    </message>
    <message>
        <source>Gap between two rings</source>
        <translation>两个圆环的间距</translation>
    </message>
    <message>
        <source>Distance between two rings that hold inclined tabs at their angle; 0 for one ring at each end</source>
        <translation>两个圆环之间的距离，使倾斜的耳片保持角度；0 表示每端一个圆环</translation>
    </message>
</context>
<context>
    <name>ElasticaPreferences</name>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>New strips</source>
        <translation>新条带</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Largest width</source>
        <translation>最大宽度</translation>
    </message>
    <message>
        <source>Tab length</source>
        <translation>耳片长度</translation>
    </message>
    <message>
        <source>Cutting files</source>
        <translation>切割文件</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>切缝</translation>
    </message>
    <message>
        <source>Clearance of slots</source>
        <translation>槽间隙</translation>
    </message>
    <message>
        <source>DXF version</source>
        <translation>DXF 版本</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Tolerance of arcs and polylines</source>
        <translation>圆弧和折线公差</translation>
    </message>
    <message>
        <source>While a sketch is edited</source>
        <translation>编辑草图时</translation>
    </message>
    <message>
        <source>Show curvature, inflections and their line</source>
        <translation>显示曲率、拐点及其直线</translation>
    </message>
    <message>
        <source>Show the nearest curve that can be bent</source>
        <translation>显示可弯成的最近曲线</translation>
    </message>
    <message>
        <source>Sheet that new strips are made of</source>
        <translation>新条带所用板材</translation>
    </message>
    <message>
        <source>Width of the widest place of new strips</source>
        <translation>新条带最宽处的宽度</translation>
    </message>
    <message>
        <source>Length of the tabs of new strips</source>
        <translation>新条带耳片的长度</translation>
    </message>
    <message>
        <source>Width removed by the cut; outlines are offset by half of it</source>
        <translation>切割去除的宽度；轮廓偏移其一半</translation>
    </message>
    <message>
        <source>Added to the width of slots in new models and plates</source>
        <translation>新模型和底板槽宽的附加量</translation>
    </message>
    <message>
        <source>The oldest version that your program reads is the safest</source>
        <translation>您的程序能读取的最旧版本最稳妥</translation>
    </message>
    <message>
        <source>Splines as drawn, or arcs or lines for machines that take nothing else</source>
        <translation>按所绘样条，或为只接受圆弧或直线的机器转换</translation>
    </message>
    <message>
        <source>Largest distance of arcs and lines from the spline</source>
        <translation>圆弧和直线与样条的最大距离</translation>
    </message>
    <message>
        <source>In sketches that strips follow, and in those made from this workbench</source>
        <translation>用于条带所跟随的草图和在此工作台中新建的草图</translation>
    </message>
    <message>
        <source>While the mouse rests, where a curve is refused</source>
        <translation>鼠标停住且曲线被拒绝时</translation>
    </message>
</context>
<context>
    <name>ElasticaProjective</name>
    <message>
        <source>Projective edit</source>
        <translation>射影编辑</translation>
    </message>
    <message>
        <source>Handles (x, y)</source>
        <translation>手柄 (x, y)</translation>
    </message>
    <message>
        <source>1, lower left</source>
        <translation>1，左下</translation>
    </message>
    <message>
        <source>2, lower right</source>
        <translation>2，右下</translation>
    </message>
    <message>
        <source>3, upper right</source>
        <translation>3，右上</translation>
    </message>
    <message>
        <source>4, upper left</source>
        <translation>4，左上</translation>
    </message>
    <message>
        <source>Put the handles back</source>
        <translation>复位手柄</translation>
    </message>
    <message>
        <source>First corner of the box, x</source>
        <translation>框的第一个角，x</translation>
    </message>
    <message>
        <source>First corner of the box, y</source>
        <translation>框的第一个角，y</translation>
    </message>
    <message>
        <source>Second corner of the box, x</source>
        <translation>框的第二个角，x</translation>
    </message>
    <message>
        <source>Second corner of the box, y</source>
        <translation>框的第二个角，y</translation>
    </message>
    <message>
        <source>Third corner of the box, x</source>
        <translation>框的第三个角，x</translation>
    </message>
    <message>
        <source>Third corner of the box, y</source>
        <translation>框的第三个角，y</translation>
    </message>
    <message>
        <source>Fourth corner of the box, x</source>
        <translation>框的第四个角，x</translation>
    </message>
    <message>
        <source>Fourth corner of the box, y</source>
        <translation>框的第四个角，y</translation>
    </message>
    <message>
        <source>Back to the box around the drawn curve</source>
        <translation>恢复为所绘曲线的外框</translation>
    </message>
</context>
<context>
    <name>ElasticaSheets</name>
    <message>
        <source>Sheet library</source>
        <translation>板材库</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>最大应变</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>切缝</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>泊松比</translation>
    </message>
    <message>
        <source>Shear modulus</source>
        <translation>剪切模量</translation>
    </message>
    <message>
        <source>Stiffness against shear in the sheet's plane, which keeps a strip from tipping sideways; plywood has far less than the estimate E / (2 (1 + ν)), which an empty field takes</source>
        <translation>板材平面内的抗剪刚度，使条带不致侧倾；胶合板的值远小于估计值 E / (2 (1 + ν))，字段为空时取该估计值</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Remove my sheet</source>
        <translation>删除我的板材</translation>
    </message>
    <message>
        <source>All known sheets, your own first</source>
        <translation>所有已知板材，自己的在前</translation>
    </message>
    <message>
        <source>Name of your sheet</source>
        <translation>您的板材名称</translation>
    </message>
    <message>
        <source>As measured with a caliper</source>
        <translation>用卡尺测量</translation>
    </message>
    <message>
        <source>Stiffness of the material along the strip; a coupon measures it</source>
        <translation>材料沿条带方向的刚度；可用试样测量</translation>
    </message>
    <message>
        <source>Mass for volume; it counts where a strip carries its weight</source>
        <translation>密度；条带承受自重时起作用</translation>
    </message>
    <message>
        <source>Largest strain of the skin before the sheet breaks or stays bent</source>
        <translation>板材断裂或残留弯曲前的最大表面应变</translation>
    </message>
    <message>
        <source>Width removed by the cut of your machine</source>
        <translation>您的机器切割去除的宽度</translation>
    </message>
    <message>
        <source>Transverse contraction as a fraction of the stretch</source>
        <translation>横向收缩与拉伸之比</translation>
    </message>
    <message>
        <source>Source of the data</source>
        <translation>数据来源</translation>
    </message>
    <message>
        <source>Takes this sheet out of your library</source>
        <translation>从库中移除此板材</translation>
    </message>
</context>
<context>
    <name>ElasticaTolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation>公差研究</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>Strips for each cause</source>
        <translation>每种原因的条带数</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Number of varied strips</source>
        <translation>变化条带的数量</translation>
    </message>
    <message>
        <source>Computes all strips; Escape stops it</source>
        <translation>计算全部条带；按 Esc 停止</translation>
    </message>
</context>
<context>
    <name>Elastica_Bend</name>
    <message>
        <source>Bend forward</source>
        <translation>继续弯曲</translation>
    </message>
    <message>
        <source>Move or turn the ends of the selected strip and watch it take its new rest shape</source>
        <translation>移动或转动所选条带的端部，观察其新的静止形状</translation>
    </message>
</context>
<context>
    <name>Elastica_Between</name>
    <message>
        <source>Draw a strip of given length between two clamps, as a curve in the open sketch</source>
        <translation>在两个夹具之间绘制给定长度的条带，作为打开的草图中的曲线</translation>
    </message>
    <message>
        <source>Curve of given length</source>
        <translation>给定长度的曲线</translation>
    </message>
</context>
<context>
    <name>Elastica_Check</name>
    <message>
        <source>Check curve</source>
        <translation>检查曲线</translation>
    </message>
    <message>
        <source>Check whether a flat strip can take the selected curve; if not, show why and where</source>
        <translation>检查平条带能否弯成所选曲线；若不能，显示原因和位置</translation>
    </message>
</context>
<context>
    <name>Elastica_Coupon</name>
    <message>
        <source>Coupon and calibrate</source>
        <translation>试样与标定</translation>
    </message>
    <message>
        <source>Make a test strip to hang over an edge, and turn its measured droop into a sheet of your own</source>
        <translation>生成悬挂试样，并由测得的下垂量得到自己的板材</translation>
    </message>
</context>
<context>
    <name>Elastica_Edit</name>
    <message>
        <source>Edit strips</source>
        <translation>编辑条带</translation>
    </message>
    <message>
        <source>Change sheet, widths and ends of all selected strips at once</source>
        <translation>一次更改所有选定条带的板材、宽度和端部</translation>
    </message>
</context>
<context>
    <name>Elastica_Export</name>
    <message>
        <source>Export cutting files</source>
        <translation>导出切割文件</translation>
    </message>
    <message>
        <source>Write DXF, SVG and STEP files, nest and cut list of the selected strips, models and base plates</source>
        <translation>写出所选条带、模型和底板的 DXF、SVG、STEP 文件、排样和下料清单</translation>
    </message>
</context>
<context>
    <name>Elastica_Fixtures</name>
    <message>
        <source>End fixtures and base plate</source>
        <translation>端部夹具与底板</translation>
    </message>
    <message>
        <source>Make printed blocks, a slotted base plate or rings that hold the ends of the selected strips or model</source>
        <translation>制作打印的夹具、开槽的底板或圆环，固定所选条带或模型的端部</translation>
    </message>
</context>
<context>
    <name>Elastica_Interlock</name>
    <message>
        <source>Interlock selected strips</source>
        <translation>互锁所选条带</translation>
    </message>
    <message>
        <source>Combine the selected strips into a model, and cut slots where they cross</source>
        <translation>将所选条带组成模型，并在相交处开槽</translation>
    </message>
</context>
<context>
    <name>Elastica_Laminate</name>
    <message>
        <source>Laminate</source>
        <translation>层压</translation>
    </message>
    <message>
        <source>Rebuild the selected strips as two glued layers: a base of even width and a narrower backing</source>
        <translation>把所选条带改为两层胶合：等宽的基层和较窄的背层</translation>
    </message>
</context>
<context>
    <name>Elastica_Live</name>
    <message>
        <source>Live feedback</source>
        <translation>实时反馈</translation>
    </message>
    <message>
        <source>Show over the open sketch whether a flat strip can take its curve, while it is drawn and dragged</source>
        <translation>在打开的草图上方显示平条带能否弯成其曲线，绘制和拖动时实时更新</translation>
    </message>
</context>
<context>
    <name>Elastica_Nearest</name>
    <message>
        <source>Nearest curve to sketch</source>
        <translation>草图的最近曲线</translation>
    </message>
    <message>
        <source>Find the curve nearest to the selected sketch that can be bent within limits</source>
        <translation>在限制内寻找与所选草图最接近的可弯曲线</translation>
    </message>
</context>
<context>
    <name>Elastica_Nest</name>
    <message>
        <source>Nest on sheets</source>
        <translation>在板材上排样</translation>
    </message>
    <message>
        <source>Arrange all cut parts of the selected strips, models and base plates on sheets</source>
        <translation>将所选条带、模型和底板的全部切割件排到板材上</translation>
    </message>
</context>
<context>
    <name>Elastica_Perforate</name>
    <message>
        <source>Perforate</source>
        <translation>打孔</translation>
    </message>
    <message>
        <source>Give the selected strips an even width, with holes that set their stiffness</source>
        <translation>使所选条带等宽，并用孔调节刚度</translation>
    </message>
</context>
<context>
    <name>Elastica_Projective</name>
    <message>
        <source>Projective edit</source>
        <translation>射影编辑</translation>
    </message>
    <message>
        <source>Pull the selected sketch's curve by four handles; if a strip can take the drawn curve, it can take the changed curve</source>
        <translation>用四个控制柄拉动所选草图的曲线；若条带之前能弯成该曲线，之后也能</translation>
    </message>
</context>
<context>
    <name>Elastica_Section</name>
    <message>
        <source>Section into curves</source>
        <translation>剖切成曲线</translation>
    </message>
    <message>
        <source>Cut the selected body, surface or mesh by planes into smooth curves that strips can follow</source>
        <translation>用平面将所选实体、曲面或网格切割为条带可以跟随的光滑曲线</translation>
    </message>
</context>
<context>
    <name>Elastica_Sheets</name>
    <message>
        <source>Sheet library</source>
        <translation>板材库</translation>
    </message>
    <message>
        <source>Show the known sheets with their sources, and store your own sheets</source>
        <translation>查看已知板材及其来源，并保存自己的板材</translation>
    </message>
</context>
<context>
    <name>Elastica_Strip</name>
    <message>
        <source>Strip from sketch</source>
        <translation>由草图生成条带</translation>
    </message>
    <message>
        <source>Make the strip that bends into the selected spline: the bent part and the linked flat part</source>
        <translation>生成可弯成所选样条的条带：弯曲件及与之关联的平面件</translation>
    </message>
</context>
<context>
    <name>Elastica_Tolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation>公差研究</translation>
    </message>
    <message>
        <source>Compute the deviation of the bent strip when sheet, cut and clamps vary within their ranges</source>
        <translation>计算板材、切割和夹持在其范围内变化时弯曲条带的偏差</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Elastica</source>
        <translation>Elastica</translation>
    </message>
    <message>
        <source>Flat strips that bend into drawn curves</source>
        <translation>弯成所绘曲线的平条带</translation>
    </message>
</context>
<context>
    <name>Elastica_Example</name>
    <message>
        <source>Open an example</source>
        <translation>打开示例</translation>
    </message>
    <message>
        <source>Open an example arch with its strip and its flat part, to try changes</source>
        <translation>打开一个示例拱形及其条带和平面件，用于尝试修改</translation>
    </message>
</context>
<context>
    <name>Elastica_Rails</name>
    <message>
        <source>Rails, ties and loads</source>
        <translation>支承杆、拉索与载荷</translation>
    </message>
    <message>
        <source>Hold the selected strip between its ends by rails, pins and cords, and load it with forces and masses</source>
        <translation>用支承杆、销和拉索在两端之间固定所选条带，并施加力和质量</translation>
    </message>
</context>
<context>
    <name>ElasticaRails</name>
    <message>
        <source>Rails, ties and loads</source>
        <translation>支承杆、拉索与载荷</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Kind of the element or load to add</source>
        <translation>要添加的元件或载荷的种类</translation>
    </message>
    <message>
        <source>Place it on the curve</source>
        <translation>放到曲线上</translation>
    </message>
    <message>
        <source>Then click the sketch or the strip in the view; for a tie, click both places</source>
        <translation>然后在视图中单击草图或条带；拉索需单击两处</translation>
    </message>
    <message>
        <source>Elements and loads</source>
        <translation>元件与载荷</translation>
    </message>
    <message>
        <source>Choose an element or load to change or remove it</source>
        <translation>选择要更改或移除的元件或载荷</translation>
    </message>
    <message>
        <source>Place along the curve</source>
        <translation>沿曲线的位置</translation>
    </message>
    <message>
        <source>Distance along the curve from its start</source>
        <translation>沿曲线距起点的距离</translation>
    </message>
    <message>
        <source>Other place</source>
        <translation>另一处</translation>
    </message>
    <message>
        <source>Distance of the other end of the tie from the start of the curve</source>
        <translation>拉索另一端距曲线起点的距离</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>Diameter of a hole in the strip for a cord or screw; 0 for none</source>
        <translation>条带上供拉索或螺钉穿过的孔的直径；0 表示无</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>缺口</translation>
    </message>
    <message>
        <source>Width of a notch in each edge of the strip, for two cords; 0 for none</source>
        <translation>条带两侧边缘上缺口的宽度，供两根拉索使用；0 表示无</translation>
    </message>
    <message>
        <source>Keep this point</source>
        <translation>保持此点</translation>
    </message>
    <message>
        <source>Keep the point in space when the curve changes, instead of the distance along the curve</source>
        <translation>曲线改变时保持空间中的点，而不是沿曲线的距离</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Removes the chosen element or load</source>
        <translation>移除所选元件或载荷</translation>
    </message>
    <message>
        <source>Force along x</source>
        <translation>沿 x 的力</translation>
    </message>
    <message>
        <source>Force along y</source>
        <translation>沿 y 的力</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Force along the x axis of the sketch</source>
        <translation>沿草图 x 轴的力</translation>
    </message>
    <message>
        <source>Force along the y axis of the sketch</source>
        <translation>沿草图 y 轴的力</translation>
    </message>
    <message>
        <source>Hung mass; it needs the own weight of the strip</source>
        <translation>悬挂质量；需要计入条带自重</translation>
    </message>
</context>
<context>
    <name>Elastica_Flexure</name>
    <message>
        <source>Two-state part</source>
        <translation>双状态零件</translation>
    </message>
    <message>
        <source>Make a part that rests in both selected curves, such as a clip that snaps, and the plate that holds it</source>
        <translation>制作在所选两条曲线中都能静止的零件，例如会突跳的卡扣，以及固定它的板</translation>
    </message>
</context>
<context>
    <name>Elastica_Flat</name>
    <message>
        <source>Flat part</source>
        <translation>平面件</translation>
    </message>
    <message>
        <source>Make the missing flat parts of the selected strips, for example of copied strips</source>
        <translation>创建所选条带缺少的平面件，例如复制的条带的平面件</translation>
    </message>
</context>
<context>
    <name>Elastica_Outline</name>
    <message>
        <source>Flat outline</source>
        <translation>平面轮廓</translation>
    </message>
    <message>
        <source>Make the outlines of the selected strips as plane faces, for pockets, tool paths and FreeCAD's own DXF files</source>
        <translation>将所选条带的轮廓创建为平面，用于凹槽、刀具路径和 FreeCAD 自带的 DXF 文件</translation>
    </message>
</context>
</TS>
