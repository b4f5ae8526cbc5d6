<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>What is off in sheet, cut and clamps, rad and mm: thickness_wave = 0.01, grain = 0.035, clamps = 0.0087, kerf = 0.05</source>
        <translation>板材、切割和夹持的偏差，单位 rad 和 mm：thickness_wave = 0.01, grain = 0.035, clamps = 0.0087, kerf = 0.05</translation>
    </message>
    <message>
        <source>How far a real strip strays from its design, by the model, what that leaves open, and its sheet</source>
        <translation>实际条带偏离设计的距离：模型所得、模型未定的部分以及板材造成的部分</translation>
    </message>
    <message>
        <source>Taper: kind = "thickness", limits = [3, 8], width = 20; or "rod", "tube"</source>
        <translation>渐变：kind = "thickness", limits = [3, 8], width = 20；或 "rod"、"tube"</translation>
    </message>
    <message>
        <source>How it strays as made and held, and by what</source>
        <translation>按实际制作和夹持如何偏离，以及原因</translation>
    </message>
    <message>
        <source>Largest distance of the strip, as it is made and held, from its design</source>
        <translation>条带按实际制作和夹持后与设计的最大距离</translation>
    </message>
    <message>
        <source>The strips, in the order of assembly</source>
        <translation>按装配顺序排列的条</translation>
    </message>
    <message>
        <source>Features that follow what is cut, and are left out</source>
        <translation>排在被切割件之后、未被包含的特征</translation>
    </message>
    <message>
        <source>Cut slots where strips cross</source>
        <translation>在条带相交处开槽</translation>
    </message>
    <message>
        <source>Added to the width of every slot</source>
        <translation>加到每个槽宽上的余量</translation>
    </message>
    <message>
        <source>Slots as the angle asks for, or as in the paper</source>
        <translation>槽按夹角确定，或按论文确定</translation>
    </message>
    <message>
        <source>Inner ends of the slots</source>
        <translation>槽的内端</translation>
    </message>
    <message>
        <source>Later strips are pushed on from here; zero leaves it open</source>
        <translation>后装的条从此方向推入；零表示不限定</translation>
    </message>
    <message>
        <source>How many slots fit into each other</source>
        <translation>互相插接的槽数</translation>
    </message>
    <message>
        <source>What was found on the way</source>
        <translation>过程中的发现</translation>
    </message>
    <message>
        <source>Strips that run into each other where no slot lets them, found a moment after the rest</source>
        <translation>在没有槽口之处互相穿入的条带；在其余结果之后片刻得出</translation>
    </message>
    <message>
        <source>The strip whose flat part this is</source>
        <translation>此平面件所属的条</translation>
    </message>
    <message>
        <source>Of a laminated strip the base, or the backing</source>
        <translation>层合条的基层或背层</translation>
    </message>
    <message>
        <source>The model whose slots it gets; none for a strip by itself</source>
        <translation>提供槽的模型；单独的条留空</translation>
    </message>
    <message>
        <source>Sketch, or edges of an object, that the strip follows</source>
        <translation>条所跟随的草图或对象的边</translation>
    </message>
    <message>
        <source>What the shape is: the strip as bent, or as cut</source>
        <translation>形状：弯曲的条或切割的条</translation>
    </message>
    <message>
        <source>Material the strip is cut from</source>
        <translation>切割条所用的材料</translation>
    </message>
    <message>
        <source>Thickness of the sheet; measure yours</source>
        <translation>板材厚度；请实测</translation>
    </message>
    <message>
        <source>The sheet's numbers, so that the file opens anywhere</source>
        <translation>板材数据，使文件在任何地方都能打开</translation>
    </message>
    <message>
        <source>Width of the widest place; 0 leaves it to MinWidth</source>
        <translation>最宽处的宽度；0 由 MinWidth 决定</translation>
    </message>
    <message>
        <source>Width of the narrowest place, or a limit for it; 0 for none</source>
        <translation>最窄处的宽度或其下限；0 表示无</translation>
    </message>
    <message>
        <source>Narrowest strip, tab or tongue that the workshop can make; 0 for what the sheet takes</source>
        <translation>车间能制作的最窄的条、端片或舌片；0 取板材的值</translation>
    </message>
    <message>
        <source>Creep factor of the sheet in the long run; 0 leaves creep out</source>
        <translation>板材的长期蠕变系数；0 表示不计蠕变</translation>
    </message>
    <message>
        <source>Where a closed strip is joined, along its curve; 0 chooses</source>
        <translation>闭合条的接合处，沿其曲线；0 为自动选择</translation>
    </message>
    <message>
        <source>Make up for anticlastic bending in the widths, where the sheet's Poisson ratio is known</source>
        <translation>在已知板材泊松比时，用宽度补偿反向弯曲</translation>
    </message>
    <message>
        <source>Make up for slots, narrow tabs and holes in the widths</source>
        <translation>用宽度补偿槽口、窄接片和孔</translation>
    </message>
    <message>
        <source>Make a strip that cannot be cut or handled, and say so</source>
        <translation>制作无法切割或拿取的条，并给出提示</translation>
    </message>
    <message>
        <source>Most of ligaments or backing, summed across; 0 for what fits</source>
        <translation>横向肋或背层总宽上限；0 表示可容纳的最大值</translation>
    </message>
    <message>
        <source>How stiffness becomes material</source>
        <translation>刚度如何变为材料</translation>
    </message>
    <message>
        <source>Width of the outline, perforated or laminated</source>
        <translation>穿孔或层合条的外廓宽度</translation>
    </message>
    <message>
        <source>Holes side by side in a perforated strip</source>
        <translation>穿孔条中并排的孔数</translation>
    </message>
    <message>
        <source>Holes one after the other; 0 chooses</source>
        <translation>纵向孔数；0 自动选择</translation>
    </message>
    <message>
        <source>Largest share of the width that holes take</source>
        <translation>孔占宽度的最大比例</translation>
    </message>
    <message>
        <source>Narrowest ligament between holes</source>
        <translation>孔间最窄的肋</translation>
    </message>
    <message>
        <source>Widest place of the narrowest hole</source>
        <translation>最窄孔的最宽处</translation>
    </message>
    <message>
        <source>Rounding of the holes' corners</source>
        <translation>孔角圆角</translation>
    </message>
    <message>
        <source>What the sides of holes are made of</source>
        <translation>孔边的曲线类型</translation>
    </message>
    <message>
        <source>Sheet that is glued on in a laminated strip</source>
        <translation>层合条粘上的板材</translation>
    </message>
    <message>
        <source>The backing's numbers</source>
        <translation>背层数据</translation>
    </message>
    <message>
        <source>Narrowest backing of a laminated strip</source>
        <translation>层合条最窄的背层</translation>
    </message>
    <message>
        <source>Holes in the tabs that align the layers; 0 for none</source>
        <translation>端片上对齐各层的孔；0 表示无</translation>
    </message>
    <message>
        <source>What holds the start of the curve</source>
        <translation>曲线起点的约束</translation>
    </message>
    <message>
        <source>What holds the end of the curve</source>
        <translation>曲线终点的约束</translation>
    </message>
    <message>
        <source>Does the strip carry its own weight?</source>
        <translation>条是否承受自重？</translation>
    </message>
    <message>
        <source>Direction in space in which things fall</source>
        <translation>空间中物体下落的方向</translation>
    </message>
    <message>
        <source>Elasto-gravity length; 0 takes the sheet's</source>
        <translation>弹性重力长度；0 取板材的值</translation>
    </message>
    <message>
        <source>Masses hung on the strip: at = 90, mass = 3 (mm, g)</source>
        <translation>挂在条上的质量：at = 90, mass = 3 (mm, g)</translation>
    </message>
    <message>
        <source>All weight in newtons: alpha = 0.001, own = true</source>
        <translation>全部重量（牛顿）：alpha = 0.001, own = true</translation>
    </message>
    <message>
        <source>Curvature of the strip before bending, 1/mm</source>
        <translation>弯曲前条的曲率，1/mm</translation>
    </message>
    <message>
        <source>Instead of it along the strip: stations = [0, 300], curvatures = [0, 0.01]</source>
        <translation>改为沿条带给出：stations = [0, 300], curvatures = [0, 0.01]</translation>
    </message>
    <message>
        <source>Nodes of the rod; 0 chooses</source>
        <translation>杆的节点数；0 自动选择</translation>
    </message>
    <message>
        <source>Follow the curve exactly, or the nearest one within limits</source>
        <translation>精确跟随曲线，或跟随限制内最近的曲线</translation>
    </message>
    <message>
        <source>Largest stiffness ratio; 0 for none</source>
        <translation>最大刚度比；0 表示无</translation>
    </message>
    <message>
        <source>Least stability margin; 5 is safely stable</source>
        <translation>最小稳定裕度；5 为可靠稳定</translation>
    </message>
    <message>
        <source>Largest strain in percent; 0 takes the sheet's</source>
        <translation>最大应变（百分比）；0 取板材的值</translation>
    </message>
    <message>
        <source>Does MarginLimit count?</source>
        <translation>MarginLimit 是否有效？</translation>
    </message>
    <message>
        <source>Does the strain limit count?</source>
        <translation>应变限制是否有效？</translation>
    </message>
    <message>
        <source>Largest curvature, 1/mm; 0 for none</source>
        <translation>最大曲率，1/mm；0 表示无</translation>
    </message>
    <message>
        <source>Least length; counts with MostLength</source>
        <translation>最小长度；与 MostLength 一起有效</translation>
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
        <source>Ground and boxes: point = [0, 0], normal = [0, 1]</source>
        <translation>地面与禁区：point = [0, 0], normal = [0, 1]</translation>
    </message>
    <message>
        <source>Along the strip: lower = 1.5, upper = [2, 3, 2]</source>
        <translation>沿条：lower = 1.5, upper = [2, 3, 2]</translation>
    </message>
    <message>
        <source>Which ends stay where they are</source>
        <translation>哪些端点保持不动</translation>
    </message>
    <message>
        <source>Keep the tangents of both ends</source>
        <translation>保持两端切线</translation>
    </message>
    <message>
        <source>Whose tangents KeepTangents keeps</source>
        <translation>KeepTangents 保持哪端的切线</translation>
    </message>
    <message>
        <source>Keep the length</source>
        <translation>保持长度</translation>
    </message>
    <message>
        <source>Mirror image or half turn that stays</source>
        <translation>保持的镜像或半转对称</translation>
    </message>
    <message>
        <source>Places along the curve that it still passes, mm</source>
        <translation>曲线仍须通过的位置，mm</translation>
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
        <translation>起点端片长度</translation>
    </message>
    <message>
        <source>Length of the tab at the end</source>
        <translation>终点端片长度</translation>
    </message>
    <message>
        <source>Rounding of the tabs' corners</source>
        <translation>端片圆角</translation>
    </message>
    <message>
        <source>Diameter of a hole in the middle of each tab; 0 for none</source>
        <translation>每个端片中央孔的直径；0 表示无</translation>
    </message>
    <message>
        <source>The first tab in full: length = 12, chamfer = 2</source>
        <translation>起点端片的完整参数：length = 12, chamfer = 2</translation>
    </message>
    <message>
        <source>The last tab in full</source>
        <translation>终点端片的完整参数</translation>
    </message>
    <message>
        <source>Slots: at = 40, width = 1.2, side = 'lower'</source>
        <translation>槽：at = 40, width = 1.2, side = 'lower'</translation>
    </message>
    <message>
        <source>Text engraved on the strip</source>
        <translation>刻在条上的文字</translation>
    </message>
    <message>
        <source>How many of it are cut</source>
        <translation>切割数量</translation>
    </message>
    <message>
        <source>Can a flat strip take the curve?</source>
        <translation>平条能否弯成此曲线？</translation>
    </message>
    <message>
        <source>Why not, and what else to know</source>
        <translation>不能的原因及其他须知</translation>
    </message>
    <message>
        <source>Largest stiffness over least stiffness</source>
        <translation>最大刚度与最小刚度之比</translation>
    </message>
    <message>
        <source>Stability margin; positive means that it stays</source>
        <translation>稳定裕度；正值表示能保持</translation>
    </message>
    <message>
        <source>Where along the strip stability is lost; 0 where it is not</source>
        <translation>沿条失稳的位置；0 表示不失稳</translation>
    </message>
    <message>
        <source>Largest strain, in percent of what the sheet bears</source>
        <translation>最大应变占板材可承受值的百分比</translation>
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
        <source>Hidden until it can be made again</source>
        <translation>隐藏直至可再次制成</translation>
    </message>
    <message>
        <source>Shown until its model can be made again</source>
        <translation>显示直至其模型可再次制成</translation>
    </message>
    <message>
        <source>Tells the request that the shape was made from</source>
        <translation>记录生成形状的请求</translation>
    </message>
    <message>
        <source>What the curve moves with</source>
        <translation>曲线随之移动的容器</translation>
    </message>
    <message>
        <source>A model, or strips, whose tabs go through it</source>
        <translation>端片穿过底板的模型或条</translation>
    </message>
    <message>
        <source>What the plate is cut from</source>
        <translation>底板的板材</translation>
    </message>
    <message>
        <source>The sheet's numbers</source>
        <translation>板材数据</translation>
    </message>
    <message>
        <source>Room beside a tab on either side</source>
        <translation>端片两侧的间隙</translation>
    </message>
    <message>
        <source>Added to the width of the slots</source>
        <translation>加到槽宽上的余量</translation>
    </message>
    <message>
        <source>Least distance of slots from the edge</source>
        <translation>槽到边缘的最小距离</translation>
    </message>
    <message>
        <source>The outline around all slots</source>
        <translation>围绕所有槽的外廓</translation>
    </message>
    <message>
        <source>A model, or strips, whose ends are held</source>
        <translation>端部被固定的模型或条</translation>
    </message>
    <message>
        <source>Room around the tab</source>
        <translation>耳片周围间隙</translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation>槽腔周围的最小厚度</translation>
    </message>
    <message>
        <source>How far the foot sticks out on either side; 0 for none</source>
        <translation>底脚两侧伸出的长度；0 表示无</translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation>底脚高度</translation>
    </message>
    <message>
        <source>Diameter of the screw holes in the foot; 0 for none</source>
        <translation>底脚螺钉孔直径；0 表示无</translation>
    </message>
    <message>
        <source>Strips, models and base plates to be cut</source>
        <translation>要切割的条、模型和底板</translation>
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
        <source>Least distance between parts and from the edge</source>
        <translation>零件之间及到边缘的最小距离</translation>
    </message>
    <message>
        <source>How many sheets are needed</source>
        <translation>所需板材数</translation>
    </message>
    <message>
        <source>Show live feedback while this sketch is open</source>
        <translation>打开此草图时显示实时反馈</translation>
    </message>
    <message>
        <source>Angle that half planes are spread over</source>
        <translation>半平面所分布的角度</translation>
    </message>
    <message>
        <source>Bodies, surfaces and meshes that are cut</source>
        <translation>被切割的实体、曲面和网格</translation>
    </message>
    <message>
        <source>How far a curve may be from the section</source>
        <translation>曲线可偏离截面的距离</translation>
    </message>
    <message>
        <source>How far the curve may be moved to smooth its curvature; 0 follows it as drawn</source>
        <translation>为使曲率光顺，曲线可移动的距离；0 表示完全按所绘曲线</translation>
    </message>
    <message>
        <source>How far the curve moves at most</source>
        <translation>曲线移动的最大距离</translation>
    </message>
    <message>
        <source>How far the end is moved along x</source>
        <translation>终点沿 x 移动的距离</translation>
    </message>
    <message>
        <source>How far the end is moved along y</source>
        <translation>终点沿 y 移动的距离</translation>
    </message>
    <message>
        <source>How far the end is turned</source>
        <translation>终点转动的角度</translation>
    </message>
    <message>
        <source>How far the start is moved along x</source>
        <translation>起点沿 x 移动的距离</translation>
    </message>
    <message>
        <source>How far the start is moved along y</source>
        <translation>起点沿 y 移动的距离</translation>
    </message>
    <message>
        <source>How far the start is turned</source>
        <translation>起点转动的角度</translation>
    </message>
    <message>
        <source>How many curves there are</source>
        <translation>曲线的数量</translation>
    </message>
    <message>
        <source>How many planes there are</source>
        <translation>平面的数量</translation>
    </message>
    <message>
        <source>How the planes stand to each other</source>
        <translation>各平面之间的相互位置</translation>
    </message>
    <message>
        <source>Sketch, wire or edges that planes stand across</source>
        <translation>平面所垂直的草图、线框或边</translation>
    </message>
    <message>
        <source>The axis of half planes passes here: x</source>
        <translation>半平面的轴通过此处：x</translation>
    </message>
    <message>
        <source>The axis of half planes passes here: y</source>
        <translation>半平面的轴通过此处：y</translation>
    </message>
    <message>
        <source>The axis of half planes passes here: z</source>
        <translation>半平面的轴通过此处：z</translation>
    </message>
    <message>
        <source>The strip that is bent further</source>
        <translation>被继续弯曲的条带</translation>
    </message>
    <message>
        <source>Waves shorter than this are smoothed away; 0 keeps them</source>
        <translation>短于此值的波纹会被抹平；0 则保留</translation>
    </message>
    <message>
        <source>What becomes of closed lines</source>
        <translation>如何处理闭合线</translation>
    </message>
    <message>
        <source>What planes stand across, or half planes about</source>
        <translation>平面所垂直的轴，或半平面所围绕的轴</translation>
    </message>
    <message>
        <source>Margin against tipping over sideways, positive where it stays in its plane; 0 where undecided</source>
        <translation>抗侧倾的裕度，为正时条带留在其平面内；未定时为 0</translation>
    </message>
    <message>
        <source>Does it stay in the plane of its curve?</source>
        <translation>条带是否留在其曲线所在的平面内？</translation>
    </message>
</context>
<context>
    <name>Elastica</name>
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
        <source>Held deviation</source>
        <translation>夹持后的偏差</translation>
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
        <source>{strip} is followed by {later}, which these files leave out: make it in the strip itself (slots, tabs, holes), or draw it into the files</source>
        <translation>{strip} 之后还有 {later}，这些文件不包含它：请在条带本身中制作（槽、端片、孔），或在文件中补画</translation>
    </message>
    <message>
        <source>{strip} is followed by {later}, which the nest leaves out: make it in the strip itself (slots, tabs, holes), or draw it into the cutting files</source>
        <translation>{strip} 之后还有 {later}，排样不包含它：请在条带本身中制作（槽、端片、孔），或在切割文件中补画</translation>
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
        <source>write the whole path of the folder, or press Browse</source>
        <translation>请写出文件夹的完整路径，或按浏览</translation>
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
        <source>what this panel works on was deleted: press Cancel</source>
        <translation>此面板所处理的对象已被删除：请按取消</translation>
    </message>
    <message>
        <source>tick what is to be made</source>
        <translation>请勾选要生成的内容</translation>
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
        <translation>端部固定件</translation>
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
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Narrowest place</source>
        <translation>最窄处</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>刚度比</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>最大应变</translation>
    </message>
    <message>
        <source>Stability margin</source>
        <translation>稳定裕度</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
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
        <source>Rows of holes (0 = chosen)</source>
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
        <source>Carries its weight</source>
        <translation>承受自重</translation>
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
        <translation>端片圆角</translation>
    </message>
    <message>
        <source>Hole in tabs</source>
        <translation>端片孔</translation>
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
        <translation>端片旁间隙</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>外廓</translation>
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
        <source>Held away by</source>
        <translation>受限于</translation>
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
        <translation>比值</translation>
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
        <translation>展平的条</translation>
    </message>
    <message>
        <source>inflections on their line</source>
        <translation>在线上的拐点</translation>
    </message>
    <message>
        <source>can</source>
        <translation>可以</translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation>无法制作</translation>
    </message>
    <message>
        <source>too short for its width</source>
        <translation>相对宽度太短</translation>
    </message>
    <message>
        <source>cannot</source>
        <translation>不行</translation>
    </message>
    <message>
        <source>would break</source>
        <translation>会断裂</translation>
    </message>
    <message>
        <source>beyond its limit</source>
        <translation>超过极限</translation>
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
        <source>How many</source>
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
        <source>Must stay in its shape</source>
        <translation>必须保持形状</translation>
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
        <source>Takes this feature's place and follows nothing any more</source>
        <translation>取代此特征，且不再跟随任何对象</translation>
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
        <source>Sideways margin</source>
        <translation>侧向裕度</translation>
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
        <source>How far the start is moved along x</source>
        <translation>起点沿 x 移动的距离</translation>
    </message>
    <message>
        <source>How far the start is moved along y</source>
        <translation>起点沿 y 移动的距离</translation>
    </message>
    <message>
        <source>How far the start is turned, degrees</source>
        <translation>起点转动的角度（度）</translation>
    </message>
    <message>
        <source>How far the end is moved along x</source>
        <translation>终点沿 x 移动的距离</translation>
    </message>
    <message>
        <source>How far the end is moved along y</source>
        <translation>终点沿 y 移动的距离</translation>
    </message>
    <message>
        <source>How far the end is turned, degrees</source>
        <translation>终点转动的角度（度）</translation>
    </message>
    <message>
        <source>Show the way from rest in small steps</source>
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
        <translation>把试条加入文档</translation>
    </message>
    <message>
        <source>Asks for a DXF or SVG file and writes the test strip into it</source>
        <translation>选择 DXF 或 SVG 文件并写入试条</translation>
    </message>
    <message>
        <source>Overhang = droop, in mm, one pair for each measurement</source>
        <translation>悬伸 = 下垂（mm），每次测量一对</translation>
    </message>
    <message>
        <source>How far a reading may be off</source>
        <translation>读数可能的误差</translation>
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
        <source>Width that the cut takes away; outlines are set off by half of it</source>
        <translation>切割损耗宽度；轮廓偏移其一半</translation>
    </message>
    <message>
        <source>How far arcs and lines may be from the spline</source>
        <translation>圆弧和直线可偏离样条的距离</translation>
    </message>
    <message>
        <source>Where the files go; asked for where it is empty</source>
        <translation>文件存放处；为空时会询问</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>Without this nothing that exists is changed</source>
        <translation>不选则不改动已有文件</translation>
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
        <translation>可打印的夹块，每个插片有一个槽</translation>
    </message>
    <message>
        <source>Room around a tab in its pocket</source>
        <translation>插片在槽中的间隙</translation>
    </message>
    <message>
        <source>Least thickness around the pocket</source>
        <translation>槽周围的最小壁厚</translation>
    </message>
    <message>
        <source>How far the foot sticks out on either side; 0 for none</source>
        <translation>底脚每侧伸出的长度；0 表示无</translation>
    </message>
    <message>
        <source>Diameter of the screw holes in the foot; 0 for none</source>
        <translation>底脚螺钉孔直径；0 表示无</translation>
    </message>
    <message>
        <source>One plate with a slot for every tab that goes through it</source>
        <translation>一块底板，每个穿过的插片有一个槽</translation>
    </message>
    <message>
        <source>What the plate is cut from</source>
        <translation>底板所用板材</translation>
    </message>
    <message>
        <source>Where the upper face of the plate lies, along z</source>
        <translation>底板上表面的 z 高度</translation>
    </message>
    <message>
        <source>Room beside a tab on either side</source>
        <translation>插片两侧的间隙</translation>
    </message>
    <message>
        <source>Added to the width of the slots</source>
        <translation>槽宽的附加量</translation>
    </message>
    <message>
        <source>Least distance of slots from the edge</source>
        <translation>槽到边缘的最小距离</translation>
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
        <source>Sheet that new strips are made of; a name of the sheet library</source>
        <translation>新条带所用板材；板材库中的名称</translation>
    </message>
    <message>
        <source>Width of the widest place of new strips</source>
        <translation>新条带最宽处的宽度</translation>
    </message>
    <message>
        <source>Length of the tabs of new strips</source>
        <translation>新条带插片的长度</translation>
    </message>
    <message>
        <source>Width that the cut takes away; outlines are set off by half of it</source>
        <translation>切割损耗宽度；轮廓偏移其一半</translation>
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
        <source>How far arcs and lines may be from the spline</source>
        <translation>圆弧和直线可偏离样条的距离</translation>
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
    <name>ElasticaSentences</name>
    <message>
        <source>bent, the backing lies inside at the start (the end at x = 0 of the cutting files), on the other side of the bend beyond each inflection: INSIDE AT START is engraved on both sheets</source>
        <translation>弯曲后，背衬在起点（切割文件中 x = 0 的一端）位于内侧，每过一个拐点换到弯曲的另一侧：两块板上都刻有 INSIDE AT START</translation>
    </message>
    <message>
        <source>bent, the backing lies outside at the start (the end at x = 0 of the cutting files), on the other side of the bend beyond each inflection: OUTSIDE AT START is engraved on both sheets</source>
        <translation>弯曲后，背衬在起点（切割文件中 x = 0 的一端）位于外侧，每过一个拐点换到弯曲的另一侧：两块板上都刻有 OUTSIDE AT START</translation>
    </message>
    <message>
        <source>bent, the backing lies inside: INSIDE is engraved on both sheets, on the faces that look there</source>
        <translation>弯曲后，背衬位于内侧：两块板朝向内侧的面上刻有 INSIDE</translation>
    </message>
    <message>
        <source>bent, the backing lies outside: OUTSIDE is engraved on both sheets, on the faces that look there</source>
        <translation>弯曲后，背衬位于外侧：两块板朝向外侧的面上刻有 OUTSIDE</translation>
    </message>
    <message>
        <source>loads hang where gravity pulls in the plane of the curve: give gravity=True or a direction in that plane, or leave loads out</source>
        <translation>载荷只在重力作用于曲线平面内时起作用：请设置 Gravity，并使 GravityDirection 位于该平面内，或去掉载荷</translation>
    </message>
    <message>
        <source>a laminate that carries its weight follows its curve exactly, from flat sheets: leave out limits, keep and natural_curvature, or gravity</source>
        <translation>承受自重的层压条精确贴合其曲线，且由平板制成：请将 Follow 设为 Exactly、NaturalCurvature 设为 0，或去掉重力</translation>
    </message>
    <message>
        <source>samples are of a strip that follows its curve exactly: leave limits and keep out, or samples</source>
        <translation>采样点（Samples）只用于精确贴合曲线的条带：请将 Follow 设为 Exactly，或去掉 Samples</translation>
    </message>
    <message>
        <source>a strip with loads hung on it follows its curve exactly: leave limits and keep out, or the loads</source>
        <translation>挂有载荷的条带精确贴合其曲线：请将 Follow 设为 Exactly，或去掉载荷</translation>
    </message>
    <message>
        <source>%1: %2 cannot be read: write keys and values, such as %3</source>
        <translation>%1：无法读取 %2：请写成键和值，例如 %3</translation>
    </message>
    <message>
        <source>a point mass is %1: it can't be negative, in g</source>
        <translation>一个质点的质量为 %1：不能为负，单位 g</translation>
    </message>
    <message>
        <source>Least%1 is %2 mm and Most%3 is %4 mm: give both, the least above 0 and not above the most</source>
        <translation>Least%1 为 %2 mm，Most%3 为 %4 mm：请两个都给出，最小值须大于 0 且不大于最大值</translation>
    </message>
    <message>
        <source>sheet %1: thickness is %2; it must be positive, in mm</source>
        <translation>板材 %1：厚度为 %2；必须为正，单位 mm</translation>
    </message>
    <message>
        <source>samples is %1: it must be a whole number, %2 or more</source>
        <translation>Samples 为 %1：必须是不小于 %2 的整数</translation>
    </message>
    <message>
        <source>creep is %1: it must be 0 or more; plywood indoors has %2 (Eurocode 5)</source>
        <translation>Creep 为 %1：必须不小于 0；室内胶合板为 %2（Eurocode 5）</translation>
    </message>
    <message>
        <source>the width of the base is %1: it must be positive, in mm</source>
        <translation>基层宽度为 %1：必须为正，单位 mm</translation>
    </message>
    <message>
        <source>deeper</source>
        <translation>更深</translation>
    </message>
    <message>
        <source>shallower or narrower</source>
        <translation>更浅或更窄</translation>
    </message>
    <message>
        <source>%1 is %2: use one of %3</source>
        <translation>%1 为 %2：请使用 %3 之一</translation>
    </message>
    <message>
        <source>tab length is %1: it must be 0 mm or more</source>
        <translation>端片长度为 %1：必须不小于 0 mm</translation>
    </message>
    <message>
        <source>tab length is %1: use 0 for no tab, or %2 mm or more</source>
        <translation>端片长度为 %1：不要端片请用 0，否则至少 %2 mm</translation>
    </message>
    <message>
        <source>glued leaves go in steps, so no stack follows a drawn curve exactly: give limits or keep, such as keep=Keep(), or call nearest_rod, and the nearest stack is found</source>
        <translation>胶合叶片的刚度成阶梯变化，因此没有叠层能精确贴合所画曲线：请给出限制或保持条件（如 keep=Keep()），或调用 nearest_rod，即可找到最接近的叠层</translation>
    </message>
    <message>
        <source>the blank is %1 mm long before it is bent, the curve %2 mm: give its curvature along the length of the curve</source>
        <translation>坯料弯曲前长 %1 mm，曲线长 %2 mm：请沿曲线的长度给出其曲率</translation>
    </message>
    <message>
        <source>a rest curvature is given at two or more stations, one curvature each: begin at 0 mm, go on to the length of the strip, and name a station twice at most, for a step between the ends</source>
        <translation>弯曲前的曲率须在两处或更多位置给出，每处一个曲率：从 0 mm 开始，到条带的长度为止；同一位置最多出现两次，表示两端之间的跃变</translation>
    </message>
    <message>
        <source>the blank has a corner at %1 mm: round it, a strip has none</source>
        <translation>坯料在 %1 mm 处有尖角：请倒圆，条带没有尖角</translation>
    </message>
    <message>
        <source>the law is of %1, the strip of %2: give both the same sheet</source>
        <translation>该规律用的是 %1，带条用的是 %2：请给两者相同的板材</translation>
    </message>
    <message>
        <source>a law says what the section is and how large: leave out style, slots, max_width and min_width, and give tabs a length only, or leave out law</source>
        <translation>规律已说明截面的形式和大小：请去掉 style、slots、max_width 和 min_width，并且接头只给长度，或去掉 law</translation>
    </message>
    <message>
        <source>The curve is on the border of what a strip can take: near %1 mm the stiffness would have to be more than %2 times that of other places. Move the curve farther from the line through its inflections, or bend it more clearly there.</source>
        <translation>曲线处于条带所能承受的边界：在 %1 mm 附近，刚度须超过别处的 %2 倍。请让曲线离拐点连线更远，或在该处弯得更明显。</translation>
    </message>
    <message>
        <source>Rods of another shape are as near, but for 2 % (%1 of them): look at `ties`, and draw the curve closer to the one you mean.</source>
        <translation>另有 %1 根不同形状的杆同样接近（相差 2 % 以内）：请查看 `ties`，并把曲线画得更接近所要的那一根。</translation>
    </message>
    <message>
        <source>strain %1 % is more than %2 % of what the sheet bears: creep is not linear there, and more than said; use a thinner sheet or a gentler curve</source>
        <translation>应变 %1 % 超过板材承受值的 %2 %：该处蠕变不再线性，且大于所述；请用更薄的板或更平缓的曲线</translation>
    </message>
    <message>
        <source>with a creep factor of %1 it will not stay in the long run: it snaps into another shape; use a stiffer sheet or support it</source>
        <translation>蠕变系数为 %1 时它不会长期保持：会突跳成另一形状；请用更硬的板或加支撑</translation>
    </message>
    <message>
        <source>section is %1: give a law with limits, such as ThicknessLaw(sheet, 3, 8, width=20)</source>
        <translation>截面为 %1：请给出带界限的规律，例如 ThicknessLaw(sheet, 3, 8, width=20)</translation>
    </message>
    <message>
        <source>compensate is %1: give True for all that widths can make up for, False for nothing, or leave it out</source>
        <translation>补偿（compensate）为 %1：True 表示补偿宽度所能补偿的一切，False 表示不补偿，或者省略</translation>
    </message>
    <message>
        <source>, its widths made for anticlastic bending,</source>
        <translation>（其宽度已补偿反向弯曲）</translation>
    </message>
    <message>
        <source>%1: poisson_ratio is given twice; leave out %2, now that it is known</source>
        <translation>%1：poisson_ratio 给了两次；既已知道，请去掉 %2</translation>
    </message>
    <message>
        <source>ignore_limits must be True or False, got %1</source>
        <translation>ignore_limits 必须为 True 或 False，而不是 %1</translation>
    </message>
    <message>
        <source>, without its correction</source>
        <translation>（未作补偿）</translation>
    </message>
    <message>
        <source>; each cause alone%1: %2</source>
        <translation>；各原因单独造成%1：%2</translation>
    </message>
    <message>
        <source>side is %1: give 1 for left of the way from start to end, -1 for right</source>
        <translation>侧为 %1：从起点到终点左侧填 1，右侧填 -1</translation>
    </message>
    <message>
        <source>a strip of %1 mm does not bend between ends %2 mm apart: make it longer, and the ends two places</source>
        <translation>长 %1 mm 的条带无法在相距 %2 mm 的两端之间弯曲：请加长，并把两端放在不同位置</translation>
    </message>
    <message>
        <source>bulges to the right</source>
        <translation>向弦的右侧拱起</translation>
    </message>
    <message>
        <source>bulges to the left</source>
        <translation>向弦的左侧拱起</translation>
    </message>
    <message>
        <source>the strip is straight</source>
        <translation>条带是直的</translation>
    </message>
    <message>
        <source>the strip's free end goes %1, with %2 inflections (mode %3)</source>
        <translation>条带的自由端%1，有 %2 个拐点（模态 %3）</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>偏向左侧</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>偏向右侧</translation>
    </message>
    <message>
        <source>a strip whose end is free turns about its start: give the angle of a clamp there</source>
        <translation>自由端的条带会绕其起点转动：请给出起点夹持的角度</translation>
    </message>
    <message>
        <source>a force moves a free end, and this one is held: give None for the end, or no force</source>
        <translation>力只移动自由端，而此端被固定：把端点设为 None，或不给力</translation>
    </message>
    <message>
        <source>the strip %1 of its chord, with %2 inflections (mode %3)</source>
        <translation>条带%1，有 %2 个拐点（模态 %3）</translation>
    </message>
    <message>
        <source>it takes no shape near its design: hold it nearer to its curve</source>
        <translation>它不会呈现接近设计的形状：请在更靠近其曲线处夹持</translation>
    </message>
    <message>
        <source>the curve is open: only a closed one can begin anywhere</source>
        <translation>曲线是开口的：只有闭合曲线才能从任意处开始</translation>
    </message>
    <message>
        <source>the curve cannot begin at %1 mm: it is %2 mm long; give a place along it</source>
        <translation>曲线不能从 %1 mm 处开始：其长度为 %2 mm；请给出曲线上的位置</translation>
    </message>
    <message>
        <source>the curve is closed with a corner of %1 degrees at %2: a strip bends without kinks; round it, or leave a gap between its ends%3</source>
        <translation>曲线在 %2 处以 %1 度的尖角闭合：条弯曲时没有折角；请将其倒圆，或在两端之间留出间隙%3</translation>
    </message>
    <message>
        <source>The curve is closed and begins where it is not bent, so places are counted from %1, %2 mm after its start.</source>
        <translation>曲线闭合，且起点处没有弯曲，因此位置从 %1 起算，即其起点之后 %2 mm。</translation>
    </message>
    <message>
        <source>a closed strip is of one sheet of even thickness, which its lap can join: take a plain or perforated strip, or leave a gap between its ends</source>
        <translation>闭合条须由一张等厚板材制成，才能用搭接连接：请采用普通条或穿孔条，或在两端之间留出间隙</translation>
    </message>
    <message>
        <source>its ends are %1 and %2 mm wide where it closes: choose another joint, leave out gravity, or make the curvature continuous there</source>
        <translation>闭合处两端宽 %1 和 %2 mm：请选择另一接合处、不计重力，或使该处曲率连续</translation>
    </message>
    <message>
        <source>glue its tab of %1 mm, bent as drawn, behind its start</source>
        <translation>将其 %1 mm 的端片按所绘形状弯曲，粘在起点背面</translation>
    </message>
    <message>
        <source>join its ends butt to butt</source>
        <translation>将两端对接</translation>
    </message>
    <message>
        <source>closed: %1 at %2, where it is %3 mm wide; the joint carries %4 N mm and %5 N</source>
        <translation>闭合：在 %2 处%1，该处宽 %3 mm；接合处承受 %4 N mm 和 %5 N</translation>
    </message>
    <message>
        <source>joint is %1 mm, but the curve is open and begins at its own end: leave joint out, or close the curve</source>
        <translation>接合处为 %1 mm，但曲线是开放的，从自身端点开始：请不要给出接合处，或将曲线闭合</translation>
    </message>
    <message>
        <source>joint is %1: give a place along the curve, 0 to %2 mm, or none</source>
        <translation>接合处为 %1：请给出沿曲线的位置，0 至 %2 mm，或不给出</translation>
    </message>
    <message>
        <source>lap joint</source>
        <translation>搭接</translation>
    </message>
    <message>
        <source>plates</source>
        <translation>接缝处的搭接板</translation>
    </message>
    <message>
        <source>steps of width</source>
        <translation>宽度突变</translation>
    </message>
    <message>
        <source>anticlastic bending</source>
        <translation>反向弯曲</translation>
    </message>
    <message>
        <source>leaning ligaments</source>
        <translation>倾斜的筋条</translation>
    </message>
    <message>
        <source>narrow tabs</source>
        <translation>窄舌片</translation>
    </message>
    <message>
        <source>slots</source>
        <translation>槽口</translation>
    </message>
    <message>
        <source>%1 mm by %2</source>
        <translation>%2 %1 mm</translation>
    </message>
    <message>
        <source>as made and held%1 the strip strays about %2 mm from its design, %3 % of its length%4: the model says %5 mm and leaves %6 mm open, and sheet, cut and clamps add %7 mm%8</source>
        <translation>按制作和夹持的实际情况%1，条带偏离设计约 %2 mm，为其长度的 %3 %%4：模型算得 %5 mm，另有 %6 mm 未定，板材、切割和夹持再加 %7 mm%8</translation>
    </message>
    <message>
        <source>, most of it from the sheet</source>
        <translation>，其中大部分来自板材</translation>
    </message>
    <message>
        <source>, most of it as modelled</source>
        <translation>，其中大部分为模型所得</translation>
    </message>
    <message>
        <source>, most of it left open by the model</source>
        <translation>，其中大部分为模型未定</translation>
    </message>
    <message>
        <source>Friction in the pockets is not counted</source>
        <translation>未计入槽座中的摩擦</translation>
    </message>
    <message>
        <source>its widths do not make up for how it is made, since it would then be %1; give it tabs as wide as its ends, or shallower slots</source>
        <translation>宽度没有补偿其做法，否则它会是 %1；请让接片与条的端部同宽，或减小槽口深度</translation>
    </message>
    <message>
        <source>Every line through the inflection at %1 mm meets the curve again or touches it there (the curve is in the way %2): wind the curve less, or support the strip between.</source>
        <translation>过 %1 mm 处拐点的每条直线都会再次与曲线相交或在该处相切（曲线%2处阻挡）：减小曲线的缠绕，或在其间支撑条带。</translation>
    </message>
    <message>
        <source>%1%2 %3, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation>%1%2 %3，在那里弯矩必须为零或变号，而曲率不变：把曲线在该处移离直线，或在该处与旁边的拐点之间支撑条带。</translation>
    </message>
    <message>
        <source>Its inflections do not lie on one %1line: those %2 are %3 mm off the nearest one%4. Move them onto one line, or support the strip between them.</source>
        <translation>拐点不在同一条%1直线上：%2处的拐点距最近直线 %3 mm%4。把它们移到一条直线上，或在其间支撑条带。</translation>
    </message>
    <message>
        <source>the line through its inflections</source>
        <translation>过各拐点的直线</translation>
    </message>
    <message>
        <source>the %1line that the supports ask for</source>
        <translation>支承所要求的%1直线</translation>
    </message>
    <message>
        <source>(at most %1 mm is put right without asking)</source>
        <translation>（不超过 %1 mm 的会自动修正）</translation>
    </message>
    <message>
        <source>undecided at this precision: the curve turns by %1 degrees at %2, %3 along it, and the digits of the file alone can turn its handle of %4 mm by %5: save it with more decimals, or make the node smooth with longer handles</source>
        <translation>在此精度下无法判定：曲线在 %2（沿线 %3）转过 %1 度，而文件的位数就足以使其 %4 mm 的手柄转动 %5：以更多小数位保存，或把节点设为平滑并加长手柄</translation>
    </message>
    <message>
        <source>The piece from %1 to %2 mm %3 and joined to a bent one, so the stiffness would have to go to 0 at the joint</source>
        <translation>%1 到 %2 mm 的一段%3，并与弯曲段相接，接点处刚度必须为零</translation>
    </message>
    <message>
        <source>The curve crosses itself (at %1 mm): two parts of the strip must pass side by side there.</source>
        <translation>曲线自相交（在 %1 mm 处）：条带的两部分必须在那里并排通过。</translation>
    </message>
    <message>
        <source>less the natural %1</source>
        <translation>减去自然曲率 %1</translation>
    </message>
    <message>
        <source>The %1 (at %2 mm) is free to turn, so the curve must have no curvature there; it has %3 1/mm%4: clamp this end, or let the curvature run out to zero.</source>
        <translation>%1（%2 mm 处）可自由转动，因此曲线在那里不能有曲率；现为 %3 1/mm%4：夹紧此端，或让曲率渐变为零。</translation>
    </message>
    <message>
        <source>The width of the strip steps %1, where the curvature jumps: smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm.</source>
        <translation>条带宽度%1处有突变，因为曲率突变：属性 Smooth = 0.1 可在 0.1 mm 内生成四次光顺曲线。</translation>
    </message>
    <message>
        <source>smooth = 0.1, or --smooth 0.1, makes it a fair curve of degree 4 within 0.1 mm</source>
        <translation>属性 Smooth = 0.1 可在 0.1 mm 内生成四次光顺曲线</translation>
    </message>
    <message>
        <source>do not repeat the knot there</source>
        <translation>不要在那里重复节点</translation>
    </message>
    <message>
        <source>The width of the strip has a kink %1, where the slope of the curvature jumps: %2.</source>
        <translation>条带宽度%1处有折角，因为曲率斜率突变：%2。</translation>
    </message>
    <message>
        <source>crosses the curve %1</source>
        <translation>%1与曲线相交</translation>
    </message>
    <message>
        <source>touches the curve %1</source>
        <translation>%1与曲线相切</translation>
    </message>
    <message>
        <source>is tangent to the curve in the inflection %1</source>
        <translation>与曲线相切于拐点（%1）</translation>
    </message>
    <message>
        <source>no small move of the control points brings the inflections onto one line</source>
        <translation>控制点的微小移动无法把拐点移到一条直线上</translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve of %1 mm.</source>
        <translation>平条带无法弯成这条长 %1 mm 的曲线。</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 个</translation>
    </message>
    <message>
        <source>A strip of any width takes this curve of %1 mm: it is not bent.</source>
        <translation>任何宽度的条带都可成为这条长 %1 mm 的曲线：它没有弯曲。</translation>
    </message>
    <message>
        <source>A flat strip can take this curve of %1 mm; it has %2, %3.</source>
        <translation>平条带可以弯成这条长 %1 mm 的曲线；它有%2，%3。</translation>
    </message>
    <message>
        <source>A flat strip can take this curve of %1 mm; it has no inflections.</source>
        <translation>平条带可以弯成这条长 %1 mm 的曲线；它没有拐点。</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked cannot take this curve of %1 mm.</source>
        <translation>按要求预弯的条带无法弯成这条长 %1 mm 的曲线。</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked has this curve of %1 mm already.</source>
        <translation>按要求预弯的条带已经是这条长 %1 mm 的曲线。</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked can take this curve of %1 mm; its bending does not change sign.</source>
        <translation>按要求预弯的条带可以弯成这条长 %1 mm 的曲线；其弯曲不变号。</translation>
    </message>
    <message>
        <source>A strip bent beforehand as asked can take this curve of %1 mm; its bending changes sign %2.</source>
        <translation>按要求预弯的条带可以弯成这条长 %1 mm 的曲线；其弯曲%2变号。</translation>
    </message>
    <message>
        <source>Under its weight an unbent strip sags, unless it is upright: draw the shape it may hang in.</source>
        <translation>未弯曲的条带会因自重下垂，除非竖直放置：画出它可以悬垂成的形状。</translation>
    </message>
    <message>
        <source>a weight in newtons needs gravity too: pass gravity=Gravity(...) for its direction</source>
        <translation>以牛顿给出的重量还需要重力：请启用 Gravity</translation>
    </message>
    <message>
        <source>The curve was moved by at most %1 mm to bring its inflections onto one line.</source>
        <translation>曲线最多移动了 %1 mm，使其拐点位于一条直线上。</translation>
    </message>
    <message>
        <source>The curve was moved by at most %1 mm to take the last bend out of its ends.</source>
        <translation>曲线最多移动了 %1 mm，使其两端完全不再弯曲。</translation>
    </message>
    <message>
        <source>The weight is far too much for the stiffness (a gravity length of %1 mm on a curve of %2 mm): use a lighter or stiffer sheet, or look at the units (200 gsm card: 96 mm).</source>
        <translation>重量相对刚度过大（重力长度 %1 mm，曲线 %2 mm）：使用更轻或更硬的板材，或检查单位（200 g/m² 卡纸：96 mm）。</translation>
    </message>
    <message>
        <source>point mass of %1 g at %2 mm does not lie on the curve of %3 mm</source>
        <translation>位于 %2 mm 的 %1 g 点质量不在长 %3 mm 的曲线上</translation>
    </message>
    <message>
        <source>in balance but it will not stay: it snaps into another shape</source>
        <translation>处于平衡但不会保持：会突跳成另一形状</translation>
    </message>
    <message>
        <source>it stays, but a push, a loose clamp or a cut that is off may make it snap</source>
        <translation>会保持，但推碰、夹具松动或切割偏差可能使其突跳</translation>
    </message>
    <message>
        <source>it stays, and comes back when pushed</source>
        <translation>会保持，推动后能恢复</translation>
    </message>
    <message>
        <source>the rod snaps %1 of the way from its present shape; here it comes to rest</source>
        <translation>杆从当前形状走到 %1 时突跳；在此静止</translation>
    </message>
    <message>
        <source>no rest shape found: %1 of the way from the present shape was possible; move the ends in smaller steps, or give a guess nearer to the answer</source>
        <translation>未找到静止形状：从当前形状只能走到 %1；请以更小的步长移动端点</translation>
    </message>
    <message>
        <source>the ends are %1 mm apart, but the rod is only %2 mm long: bring them closer or use a longer rod</source>
        <translation>两端相距 %1 mm，而杆长仅 %2 mm：把两端靠近，或使用更长的杆</translation>
    </message>
    <message>
        <source>the ends are as far apart as the rod is long (%1 mm), so it must be straight, which its end angles or its weight do not allow: bring the ends closer together</source>
        <translation>两端距离等于杆长（%1 mm），杆必须是直的，但端部角度或重量不允许：把两端靠近</translation>
    </message>
    <message>
        <source>a force along %1 does nothing: both ends hold %2; free one end along %3</source>
        <translation>沿 %1 的力不起作用：两端都约束 %2；沿 %3 放开一端</translation>
    </message>
    <message>
        <source>both ends turn freely: give the moments of both, (start, end)</source>
        <translation>两端均可自由转动：请给出两端弯矩（起点，终点）</translation>
    </message>
    <message>
        <source>a moment at the %1 does nothing: its support holds the angle; free the angle there</source>
        <translation>%1处的弯矩不起作用：支承约束了角度；请在那里放开角度</translation>
    </message>
    <message>
        <source>the slot for %1%2 is %3 mm wide for a tab of %4 mm, which it cannot hold</source>
        <translation>%1%2 的槽宽 %3 mm，插片 %4 mm，无法固定</translation>
    </message>
    <message>
        <source>end the strips steeper to the plate, take a thinner plate, or hold them by end fixtures</source>
        <translation>让条带更陡地接触底板，使用更薄的底板，或用端部夹具固定</translation>
    </message>
    <message>
        <source>beside the tab of %1 the strip would stand %2 mm deep in the plate</source>
        <translation>在 %1 的插片旁，条带会陷入底板 %2 mm</translation>
    </message>
    <message>
        <source>give it a tab as wide as the strip, or set the plate so much lower</source>
        <translation>让插片与条带同宽，或把底板降低相同的距离</translation>
    </message>
    <message>
        <source>make it wider (max_width), or ask for the nearest curve with a smaller ratio</source>
        <translation>加宽（MaxWidth），或改用刚度比更小的最近曲线</translation>
    </message>
    <message>
        <source>ligaments down to %1 mm are allowed, %2 mm are needed</source>
        <translation>允许的筋宽低至 %1 mm，而需要 %2 mm</translation>
    </message>
    <message>
        <source>%1 mm long and %2 mm wide: too slender to handle</source>
        <translation>长 %1 mm、宽 %2 mm：过于细长，难以操作</translation>
    </message>
    <message>
        <source>(and %1 more)</source>
        <translation>（以及另外 %1 个）</translation>
    </message>
    <message>
        <source>only %1 mm wide %2%3, %4 mm are needed in %5</source>
        <translation>%2%3仅宽 %1 mm，%5 需要 %4 mm</translation>
    </message>
    <message>
        <source>(and %1 more places)</source>
        <translation>（以及另外 %1 处）</translation>
    </message>
    <message>
        <source>at %1 mm along it</source>
        <translation>沿线 %1 mm 处</translation>
    </message>
    <message>
        <source>at (%1, %2) mm</source>
        <translation>在 (%1, %2) mm 处</translation>
    </message>
    <message>
        <source>ask for wider ligaments, or fewer columns</source>
        <translation>要求更宽的筋，或减少列数</translation>
    </message>
    <message>
        <source>make it wider, or split it</source>
        <translation>加宽，或分段</translation>
    </message>
    <message>
        <source>leave more room between the slots: a larger ring or plate, fewer or narrower strips, a wider border</source>
        <translation>在槽之间留更多空间：更大的环或板、更少或更窄的条带、更宽的边</translation>
    </message>
    <message>
        <source>%1 x %2 mm is larger than the stock of %3 mm in %4</source>
        <translation>%1 x %2 mm 大于 %4 的板料 %3 mm</translation>
    </message>
    <message>
        <source>name a larger stock, split it, or scale the curve</source>
        <translation>使用更大的板料，分段，或缩小曲线</translation>
    </message>
    <message>
        <source>the stock is %1: give the two sides of the sheet in mm</source>
        <translation>板料为 %1：请以 mm 给出板的两边</translation>
    </message>
    <message>
        <source>%1 is %2: give a positive width in mm</source>
        <translation>%1 为 %2：请给出以 mm 为单位的正宽度</translation>
    </message>
    <message>
        <source>the laminate cannot be as soft as it should at %1 mm (base %2 mm, K %3) and as stiff at %4 mm (base %5 mm, K %6):</source>
        <translation>层压条无法在 %1 mm 处足够柔软（基层 %2 mm，K %3），同时在 %4 mm 处足够刚硬（基层 %5 mm，K %6）：</translation>
    </message>
    <message>
        <source>narrow the base at %1 mm</source>
        <translation>在 %1 mm 处收窄基层</translation>
    </message>
    <message>
        <source>widen it at %1 mm</source>
        <translation>在 %1 mm 处加宽</translation>
    </message>
    <message>
        <source>the width of the base</source>
        <translation>基层宽度</translation>
    </message>
    <message>
        <source>make the backing %1 times as thick as the base or more (now %2 times)</source>
        <translation>使背层厚度至少为基层的 %1 倍（现为 %2 倍）</translation>
    </message>
    <message>
        <source>dots are %1 mm across: give a diameter, 0 for none</source>
        <translation>定位孔为 %1 mm：请给出直径，0 表示无</translation>
    </message>
    <message>
        <source>the base is %1 mm wide at %2 mm, narrower than the least backing of %3 mm: widen it there</source>
        <translation>基层在 %2 mm 处宽 %1 mm，窄于最小背层 %3 mm：请在那里加宽</translation>
    </message>
    <message>
        <source>a backing of at least %1 mm at %2 mm is wider than max_width %3 mm at %4 mm: raise max_width</source>
        <translation>在 %2 mm 处至少 %1 mm 的背层宽于 %4 mm 处的 MaxWidth %3 mm：请增大 MaxWidth</translation>
    </message>
    <message>
        <source>choose other widths (%1)</source>
        <translation>选择其他宽度（%1）</translation>
    </message>
    <message>
        <source>%1, when holes still fit at %2 mm: %3</source>
        <translation>若在 %2 mm 处仍能开孔，%1：%3</translation>
    </message>
    <message>
        <source>ligaments would be %1 mm wide at %2 mm, below %3 mm</source>
        <translation>在 %2 mm 处筋宽将为 %1 mm，低于 %3 mm</translation>
    </message>
    <message>
        <source>the width of the outline</source>
        <translation>轮廓宽度</translation>
    </message>
    <message>
        <source>make the outline %1 mm or more wide there (now %2 mm)</source>
        <translation>把那里的轮廓加宽到 %1 mm 以上（现为 %2 mm）</translation>
    </message>
    <message>
        <source>holes would take %1 % of the width at %2 mm, more than %3 %</source>
        <translation>在 %2 mm 处孔将占宽度的 %1 %，超过 %3 %</translation>
    </message>
    <message>
        <source>hole_ratio is %1: it must lie between 0 and 1</source>
        <translation>HoleRatio 为 %1：必须在 0 与 1 之间</translation>
    </message>
    <message>
        <source>sides are "spline" or "arc", not %1</source>
        <translation>孔边为 "spline" 或 "arc"，而不是 %1</translation>
    </message>
    <message>
        <source>the outline is %1 mm wide at %2 mm: %3 ligaments of %4 mm and %5 columns of holes need more than %6 mm; widen it or use fewer columns</source>
        <translation>轮廓在 %2 mm 处宽 %1 mm：%3 条 %4 mm 的筋和 %5 列孔需要超过 %6 mm；加宽，或减少列数</translation>
    </message>
    <message>
        <source>use a thinner or softer sheet</source>
        <translation>使用更薄或更软的板材</translation>
    </message>
    <message>
        <source>%1: the ligaments need %2 mm in all where they are widest, not %3 mm; %4</source>
        <translation>%1：最宽处各筋合计需要 %2 mm，而不是 %3 mm；%4</translation>
    </message>
    <message>
        <source>the ligaments are %1 mm in all at the narrowest place, below min_width %2 mm: widen the outline or lower the stiffness ratio</source>
        <translation>最窄处各筋合计 %1 mm，低于 MinWidth %2 mm：加宽轮廓或降低刚度比</translation>
    </message>
    <message>
        <source>allow a hole_ratio of %1</source>
        <translation>允许 HoleRatio 为 %1</translation>
    </message>
    <message>
        <source>lower the stiffness ratio from %1 to %2</source>
        <translation>把刚度比从 %1 降到 %2</translation>
    </message>
    <message>
        <source>%1 is %2: a perforated strip has a whole number of them, from 1</source>
        <translation>%1 为 %2：穿孔条带应为不小于 1 的整数</translation>
    </message>
    <message>
        <source>the slots leave %1 % of the stiffness at %2 mm and move the shape by %3 mm</source>
        <translation>槽使 %2 mm 处刚度剩 %1 %，并使形状移动 %3 mm</translation>
    </message>
    <message>
        <source>%1 mm long, %2 to %3 mm wide</source>
        <translation>长 %1 mm，宽 %2 至 %3 mm</translation>
    </message>
    <message>
        <source>a strip needs max_width or min_width (mm): the rod only fixes how widths compare</source>
        <translation>条带需要 MaxWidth 或 MinWidth（mm）：杆只确定宽度之比</translation>
    </message>
    <message>
        <source>the narrowest place is %1 mm, below min_width %2 mm: the ratio is %3, so max_width must be %4 mm or more</source>
        <translation>最窄处 %1 mm，低于 MinWidth %2 mm：刚度比为 %3，因此 MaxWidth 须不小于 %4 mm</translation>
    </message>
    <message>
        <source>%1 is given over %2 mm, the strip is %3 mm long</source>
        <translation>%1 给出的长度为 %2 mm，条带长 %3 mm</translation>
    </message>
    <message>
        <source>a T-slot needs positive sizes in mm: depth, screw, nut = (width, height), wall</source>
        <translation>T 形槽需要以 mm 为单位的正尺寸：深度、螺钉、螺母 =（宽，高）、壁厚</translation>
    </message>
    <message>
        <source>a nut of %1 mm is held by nothing in a slot of %2 mm: make it wider</source>
        <translation>%1 mm 的螺母在 %2 mm 的槽中无法固定：请加宽</translation>
    </message>
    <message>
        <source>a T-slot of %1 mm ends before its nut is in, at %2 mm: make it deeper</source>
        <translation>%1 mm 的 T 形槽在螺母位置 %2 mm 之前结束：请加深</translation>
    </message>
    <message>
        <source>a T-slot of %1 mm does not fit a tab of %2 mm: lengthen the tab</source>
        <translation>%1 mm 的 T 形槽放不进 %2 mm 的插片：请加长插片</translation>
    </message>
    <message>
        <source>tab corners of %1 mm do not fit a tab of %2 by %3 mm: make them smaller</source>
        <translation>%1 mm 的插片圆角不适合 %2 x %3 mm 的插片：请减小</translation>
    </message>
    <message>
        <source>a taper of %1 mm leaves nothing of a tab %2 mm wide: make it smaller</source>
        <translation>%1 mm 的锥度会使 %2 mm 宽的插片消失：请减小</translation>
    </message>
    <message>
        <source>the nut of a T-slot, %1 mm, is wider than the tab's outer edge of %2 mm: make the tab wider</source>
        <translation>T 形槽的螺母 %1 mm 宽于插片外缘 %2 mm：请加宽插片</translation>
    </message>
    <message>
        <source>holes of %1 mm and %2 mm, %3 and %4 mm into the tab, meet: move one of them</source>
        <translation>插片内 %3 mm 和 %4 mm 处、直径 %1 mm 和 %2 mm 的孔相交：移动其中一个</translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm into the tab does not fit its length of %3 mm: move it or lengthen the tab</source>
        <translation>插片内 %2 mm 处的 %1 mm 孔放不进长 %3 mm 的插片：移动孔或加长插片</translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm off the centre line breaks the edge of a %3 mm wide tab: make it smaller or the tab wider</source>
        <translation>偏离中线 %2 mm 的 %1 mm 孔会破坏 %3 mm 宽插片的边缘：减小孔或加宽插片</translation>
    </message>
    <message>
        <source>a %1 mm hole %2 mm into the tab meets its T-slot: move it aside</source>
        <translation>插片内 %2 mm 处的 %1 mm 孔与 T 形槽相交：请移开</translation>
    </message>
    <message>
        <source>gravity %1 is a direction in space: give frame, the plane of the curve, or two numbers, the direction in the drawing</source>
        <translation>重力 %1 是空间方向：请给出曲线的平面</translation>
    </message>
    <message>
        <source>%1 To make it all the same, set ignore_limits (--ignore-limits).</source>
        <translation>%1 若仍要制作，请设置 Anyway。</translation>
    </message>
    <message>
        <source>what is hung on the rod bends it nowhere (a held end carries it, or its mass is 0): hang it between the ends, or leave it out</source>
        <translation>挂在杆上的重物没有使杆弯曲（它由固定的一端承受，或其质量为 0）：请把它挂在两端之间，或去掉它</translation>
    </message>
    <message>
        <source>a laminate that carries its weight must stand upright and weigh what its sheets do: turn its plane, give gravity=True or the base sheet's gravity, or leave gravity out</source>
        <translation>承受自重的层压条必须竖立，且重量等于其板材：转动其平面，或去掉重力</translation>
    </message>
    <message>
        <source>%1 is %2 mm, outside the limit width of %3 to %4 mm: change one of them, or leave the limit out</source>
        <translation>%1 为 %2 mm，超出宽度限制 %3 至 %4 mm：请更改其中之一，或去掉该限制</translation>
    </message>
    <message>
        <source>min_width is %1 mm, more than max_width, %2 mm: give the larger one as max_width</source>
        <translation>MinWidth 为 %1 mm，大于 MaxWidth 的 %2 mm：请把较大的值填为 MaxWidth</translation>
    </message>
    <message>
        <source>max_width is %1 mm, but %2 needs %3 mm at its narrowest: widen the strip, take another sheet, or allow less with shop=Shop(least_width=...)</source>
        <translation>MaxWidth 为 %1 mm，但 %2 最窄处需要 %3 mm：加宽条带，换板材，或减小 LeastWidth</translation>
    </message>
    <message>
        <source>slot at %1 mm</source>
        <translation>%1 mm 处的槽</translation>
    </message>
    <message>
        <source>a bent slot needs four points or more along its centre line</source>
        <translation>弯曲的槽沿中线需要四个以上的点</translation>
    </message>
    <message>
        <source>%1: the slots at %2 mm and %3 mm meet: move them apart, or make them narrower or shallower</source>
        <translation>%1：%2 mm 与 %3 mm 处的槽相连：移开，或改窄、改浅</translation>
    </message>
    <message>
        <source>does not open at the edge</source>
        <translation>没有开到边缘</translation>
    </message>
    <message>
        <source>cuts through to another edge</source>
        <translation>切穿到另一边缘</translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm %3: make it %4 or move it</source>
        <translation>%1：%2 mm 处的槽%3：使其%4，或移动它</translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm is not on the strip, which goes from %3 to %4 mm with its tabs: move it</source>
        <translation>%1：%2 mm 处的槽不在条带上，条带连同端片从 %3 到 %4 mm：移动它</translation>
    </message>
    <message>
        <source>%1: the slot at %2 mm meets a hole at %3: move one of them</source>
        <translation>%1：%2 mm 处的槽与 %3 处的孔相交：移动其中之一</translation>
    </message>
    <message>
        <source>assembly: %1; push each strip onto those before it</source>
        <translation>装配：%1；把每条条带推到前面的条带上</translation>
    </message>
    <message>
        <source>%1 and %2 touch along a line at %3 mm of %4 instead of crossing: move them apart or turn one of them</source>
        <translation>%1 与 %2 在 %4 的 %3 mm 处沿线接触而非交叉：移开或转动其一</translation>
    </message>
    <message>
        <source>no two strips cross: interlocking cut no slot</source>
        <translation>没有条带相交：未切槽</translation>
    </message>
    <message>
        <source>; %1 must be threaded in, being held from both edges</source>
        <translation>；%1 两边都被夹住，须穿入</translation>
    </message>
    <message>
        <source>%1 and %2 cross at %3 degrees at %4 mm of %5: the slots are up to %6 mm wide; a larger angle would hold better</source>
        <translation>%1 与 %2 在 %5 的 %4 mm 处以 %3 度相交：槽宽达 %6 mm；更大的角度固定更好</translation>
    </message>
    <message>
        <source>%1: the slots open its outline</source>
        <translation>%1：槽使其轮廓断开</translation>
    </message>
    <message>
        <source>%1 and %2 cross at %3 mm of %4, but one of them ends before the crossing comes to its edge, so that no slot can open there: shorten, move or turn one of them</source>
        <translation>%1 与 %2 在 %4 的 %3 mm 处相交，但其一在交点到达边缘前就结束，无法开槽：缩短、移动或转动其一</translation>
    </message>
    <message>
        <source>a clearance of %1 mm is larger than %2 is wide at %3 mm: make it smaller</source>
        <translation>%1 mm 的间隙大于 %2 在 %3 mm 处的宽度：请减小</translation>
    </message>
    <message>
        <source>the model %1 has no strips</source>
        <translation>模型 %1 没有条带</translation>
    </message>
    <message>
        <source>the model %1 has %2, made for its strips where they are: repeat the strips without rings</source>
        <translation>模型 %1 有 %2，是为其条带的现有位置制作的：请不带环地重复条带</translation>
    </message>
    <message>
        <source>%1: no tab of the model goes down through the plate, their tips are %2 to %3 mm above its upper face: move the plate to where the strips end, give the strips longer tabs, or hold ends that come from below by rings</source>
        <translation>%1：模型没有插片向下穿过底板，插片末端位于底板上表面上方 %2 至 %3 毫米：把底板移到条带末端，加长插片，或用圆环固定从下方伸来的末端</translation>
    </message>
    <message>
        <source>%1: there is no strip for it to hold: name other strips or ends</source>
        <translation>%1：没有可固定的条带：请指定其他条带或末端</translation>
    </message>
    <message>
        <source>%1: the tab of %2 leans to %3 degrees from the plate: at %4 degrees or less a slot cannot hold it; use a fixture there</source>
        <translation>%1：%2 的插片与底板成 %3 度：%4 度以下槽无法固定；请在那里使用夹具</translation>
    </message>
    <message>
        <source>%1: the slots of %2 and %3 come closer than %4 mm near (%5, %6): give the strips narrower tabs or move them apart</source>
        <translation>%1：%2 与 %3 的槽在 (%5, %6) 附近距离小于 %4 mm：改窄插片，或移开</translation>
    </message>
    <message>
        <source>%1: a screw of %2 mm does not fit a foot of %3 by %4 mm: make the foot longer or the screw thinner</source>
        <translation>%1：%2 mm 的螺钉放不进 %3 x %4 mm 的底脚：加长底脚或用更细的螺钉</translation>
    </message>
    <message>
        <source>%1: the plane of the strip leans %2 degrees to the floor: leave the floor out, and the block stands square to its tab</source>
        <translation>%1：条带平面与地面倾斜 %2 度：不用地面，夹块就会与插片垂直</translation>
    </message>
    <message>
        <source>%1: the block reaches %2 mm below the floor: lower the floor or shorten the tab</source>
        <translation>%1：夹块低于地面 %2 mm：降低地面或缩短插片</translation>
    </message>
    <message>
        <source>a strip has the ends "start" and "end", not %1</source>
        <translation>条带的两端为 "start" 和 "end"，而不是 %1</translation>
    </message>
    <message>
        <source>every piece fits the sheet</source>
        <translation>每个零件都放得进板材</translation>
    </message>
    <message>
        <source>the kerf is %1: it must be a finite number of mm, 0 for none</source>
        <translation>切缝为 %1：须为有限的毫米数，0 表示没有</translation>
    </message>
    <message>
        <source>the kerf is %1 mm, wider than the cut of any tool: give the width of the cut in mm, such as 0.15 for a laser</source>
        <translation>切缝为 %1 mm，比任何刀具的切缝都宽：请以毫米给出切缝宽，激光如 0.15</translation>
    </message>
    <message>
        <source>a kerf of %1 mm is too wide for a loop on %2: %3</source>
        <translation>切缝 %1 mm 对 %2 上的轮廓过宽：%3</translation>
    </message>
    <message>
        <source>with a kerf of %1 mm two cut loops meet at %2: move them apart there or use a smaller kerf</source>
        <translation>切缝为 %1 mm 时两条切割轮廓在 %2 相遇：把它们移开，或使用更小的切缝</translation>
    </message>
    <message>
        <source>%1: %2 by %3 mm is larger than a sheet of %4 by %5 mm with a margin of %6 mm%7: use a larger sheet or make the part in pieces</source>
        <translation>%1：%2 x %3 mm 大于 %4 x %5 mm 的板材（边距 %6 mm）%7：使用更大的板材，或把零件分段</translation>
    </message>
    <message>
        <source>with the grain %1 it</source>
        <translation>沿纹理 %1</translation>
    </message>
    <message>
        <source>the edge has no length: draw a curve for the strip to follow</source>
        <translation>该边没有长度：请画一条供条带跟随的曲线</translation>
    </message>
    <message>
        <source>no edge was given: give at least one edge or wire for the strip to follow</source>
        <translation>没有给出任何边：请至少给出一条供条带跟随的边或线框</translation>
    </message>
    <message>
        <source>the edges make %1 separate chains, the nearest %2 mm apart at %3: make their ends meet, or leave out what the strip is not to follow, in a sketch as construction geometry</source>
        <translation>这些边组成 %1 条分离的链，最近处在 %3 相距 %2 mm：请使其端点相接，或略去条带不应跟随的部分，草图中设为辅助几何</translation>
    </message>
    <message>
        <source>two edges end %1 mm apart at %2: make their ends meet there, in a sketch by a coincident constraint</source>
        <translation>两条边的端点在 %2 处相距 %1 mm：请使端点在该处相接，草图中用重合约束</translation>
    </message>
    <message>
        <source>three edges or more meet at %1: a strip goes on in one way, so give only the edges that it is to follow</source>
        <translation>三条或更多的边在 %1 处相接：条带只沿一条路延续，请只给出它要沿着的边</translation>
    </message>
    <message>
        <source>the curve lies up to %1 mm off the plane that is given for it: give the one in which it is drawn, or none</source>
        <translation>曲线偏离给定平面达 %1 mm：请给出绘制它的平面，或不给</translation>
    </message>
    <message>
        <source>edges meet at a corner of %1 degrees at (%2, %3, %4) mm: make them tangent or round the corner</source>
        <translation>边在 (%2, %3, %4) mm 处以 %1 度角相交：使其相切或把角倒圆</translation>
    </message>
    <message>
        <source>the margin is %1: it must be a number of mm, 0 or more</source>
        <translation>边距为 %1：须为以 mm 计的数，0 或更大</translation>
    </message>
    <message>
        <source>sheet size is %1: give its width and height, two numbers of mm</source>
        <translation>板材尺寸为 %1：请给出宽和高，即两个以 mm 计的数</translation>
    </message>
    <message>
        <source>the edges are a polyline of %1 straight pieces, with corners between them: draw a spline through its points for the strip to follow</source>
        <translation>这些边是由 %1 段直线组成的折线，段间有拐角：请过其各点画一条样条曲线供条带跟随</translation>
    </message>
    <message>
        <source>a spline of degree %1 has %2 control points; it needs %3: draw it anew</source>
        <translation>%1 次样条有 %2 个控制点；需要 %3 个：请重画</translation>
    </message>
    <message>
        <source>a spline of degree %1 with %2 control points has %3 knots; it needs %4, never decreasing: export it anew, or draw it anew</source>
        <translation>有 %2 个控制点的 %1 次样条有 %3 个节点；需要 %4 个，且不递减：请重新导出或重画</translation>
    </message>
    <message>
        <source>all knots of a spline are %1; its parameter must run over an interval: draw it anew</source>
        <translation>样条的所有节点均为 %1；其参数须跨越一个区间：请重画</translation>
    </message>
    <message>
        <source>%1 is a folder: give the name of a file in it</source>
        <translation>%1 是文件夹：请给出其中的文件名</translation>
    </message>
    <message>
        <source>%1 can't be written: there is no folder %2; create it first</source>
        <translation>无法写入 %1：没有文件夹 %2；请先创建</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name, or allow it to be overwritten (--force, or force=True)</source>
        <translation>%1 已存在：请换名，或允许覆盖</translation>
    </message>
    <message>
        <source>%1 can't be written: no permission to change that file; choose another name</source>
        <translation>无法写入 %1：没有修改该文件的权限；请换名</translation>
    </message>
    <message>
        <source>%1 can't be written: %2; choose another place</source>
        <translation>无法写入 %1：%2；请换位置</translation>
    </message>
    <message>
        <source>%1 can't be changed: %2; allow it to be written</source>
        <translation>无法更改 %1：%2；请允许写入</translation>
    </message>
    <message>
        <source>All limits are met, and no nearer rod was found.</source>
        <translation>满足所有限制，未找到更近的杆。</translation>
    </message>
    <message>
        <source>All limits are met, but the search was stopped before it settled: a nearer rod may exist.</source>
        <translation>满足所有限制，但搜索提前停止：可能存在更近的杆。</translation>
    </message>
    <message>
        <source>All limits are met, but only by a rod that no longer looks like the drawn curve: relax what binds.</source>
        <translation>满足所有限制，但结果已不像所绘曲线：请放宽起约束作用的限制。</translation>
    </message>
    <message>
        <source>The limits cannot be met together near this curve: this is the best rod found, relax what binds.</source>
        <translation>在该曲线附近无法同时满足这些限制：这是找到的最好结果，请放宽起约束作用的限制。</translation>
    </message>
    <message>
        <source>No rod was computed for this curve: see the message.</source>
        <translation>未能为该曲线算出杆：请看消息。</translation>
    </message>
    <message>
        <source>The rod leaves the drawn curve by %1 mm at most.</source>
        <translation>杆偏离所绘曲线最多 %1 mm。</translation>
    </message>
    <message>
        <source>there is no rod for this curve: %1</source>
        <translation>该曲线没有对应的杆：%1</translation>
    </message>
    <message>
        <source>%1 costs %2 %3</source>
        <translation>%1 的代价为 %2 %3</translation>
    </message>
    <message>
        <source>all limits are met, %1 mm from the drawn curve at most.</source>
        <translation>满足所有限制，距所绘曲线最多 %1 mm。</translation>
    </message>
    <message>
        <source>the ratio of the widths</source>
        <translation>宽度之比</translation>
    </message>
    <message>
        <source>the sheet's strain limit</source>
        <translation>板材的应变极限</translation>
    </message>
    <message>
        <source>The stability margin of %1 is missed: this rod has %2.</source>
        <translation>未达到稳定裕度 %1：该杆为 %2。</translation>
    </message>
    <message>
        <source>No single one of the limits that bind is to blame: relax several.</source>
        <translation>并非单个限制所致：请放宽多个限制。</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1 而不是 %2</translation>
    </message>
    <message>
        <source>%1 instead of %2 mm</source>
        <translation>%1 而不是 %2 mm</translation>
    </message>
    <message>
        <source>the range of lengths</source>
        <translation>长度范围</translation>
    </message>
    <message>
        <source>the %1 end's angle</source>
        <translation>%1端的角度</translation>
    </message>
    <message>
        <source>Free %1: that saves %2 %3.</source>
        <translation>放开 %1：可节省 %2 %3。</translation>
    </message>
    <message>
        <source>; %1 would cost %2 mm</source>
        <translation>；%1 将付出 %2 mm</translation>
    </message>
    <message>
        <source>%1 of %2 costs %3 %4 per unit (its multiplier: true of small changes).</source>
        <translation>%2 的 %1 每单位代价为 %3 %4（乘子：仅适用于小变化）。</translation>
    </message>
    <message>
        <source>%1 at %2: %3</source>
        <translation>%1 在 %2：%3</translation>
    </message>
    <message>
        <source>split it at its corners</source>
        <translation>在拐角处分割</translation>
    </message>
    <message>
        <source>(%1, %2, %3) mm</source>
        <translation>(%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>no smooth curve stays within the tolerance of %1 mm: the section turns by %2 degrees at %3; %4, or smooth it</source>
        <translation>没有光滑曲线能保持在 %1 mm 公差内：截面在 %3 转过 %2 度；%4，或使其光顺</translation>
    </message>
    <message>
        <source>%1: the curve lies %2 mm off the section at %3, more than the tolerance of %4 mm: %5</source>
        <translation>%1：曲线在 %3 处偏离截面 %2 mm，超过公差 %4 mm：%5</translation>
    </message>
    <message>
        <source>%1, from (%2, %3, %4) mm</source>
        <translation>%1，从 (%2, %3, %4) mm 起</translation>
    </message>
    <message>
        <source>and at %1 more places</source>
        <translation>以及另外 %1 处</translation>
    </message>
    <message>
        <source>%1 mm along the curve%2 it turns by less than %3 degrees between inflections; no smoothing that moves it by less than %4 mm takes that away</source>
        <translation>沿曲线 %1 mm%2，拐点之间的转角小于 %3 度；移动小于 %4 mm 的光顺无法消除</translation>
    </message>
    <message>
        <source>every section is a closed line, and a strip has two ends: choose under Closed lines how they are divided</source>
        <translation>每个截面都是闭合线，而条带有两个端点：请在“闭合线”下选择如何分割</translation>
    </message>
    <message>
        <source>readings %1 mm</source>
        <translation>读数 %1 mm</translation>
    </message>
    <message>
        <source>elasto-gravity length %1 +- %2 mm</source>
        <translation>弹性重力长度 %1 +- %2 mm</translation>
    </message>
    <message>
        <source>the section is closed (it passes (%1, %2, %3) mm): a strip has two ends, so %4</source>
        <translation>截面是闭合的（经过 (%1, %2, %3) mm）：条带有两端；%4</translation>
    </message>
    <message>
        <source>split it at a spine or at two points</source>
        <translation>请把它分成两半（“闭合线”）</translation>
    </message>
    <message>
        <source>the points to smooth are all the same</source>
        <translation>要光顺的点全部相同</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
    <message>
        <source>%1: %2: it is kept</source>
        <translation>%1：%2：保留</translation>
    </message>
    <message>
        <source>%1 at %2: the plane %3</source>
        <translation>%1 在 %2：平面%3</translation>
    </message>
    <message>
        <source>%1 is split twice at one place, or at its very end: move the points</source>
        <translation>%1 在同一处或末端被分割两次：请移动分割点</translation>
    </message>
    <message>
        <source>%1: choose from its lines</source>
        <translation>%1：请从其线中选择</translation>
    </message>
    <message>
        <source>%1 falls into %2 lines, starting at %3</source>
        <translation>%1 分成 %2 条线，起点在 %3</translation>
    </message>
    <message>
        <source>smooth is %1: a curve is made fair within 0 (not at all) to %2 mm</source>
        <translation>Smooth 为 %1：曲线的光顺范围为 0（不光顺）至 %2 mm</translation>
    </message>
    <message>
        <source>The digits of the file turn its tangents where pieces meet: put right, %1 mm at most.</source>
        <translation>文件的位数使各段相接处的切线转动：已修正，最多 %1 mm。</translation>
    </message>
    <message>
        <source>as drawn no strip takes it</source>
        <translation>按所绘，没有条带能成为它</translation>
    </message>
    <message>
        <source>the stiffness ratio as drawn was %1</source>
        <translation>按所绘的刚度比为 %1</translation>
    </message>
    <message>
        <source>The curvature jumped where pieces meet: made fair, %1 mm from the drawn curve at most; %2 (smooth = 0, or --smooth 0, takes it as drawn, a larger number makes it fairer).</source>
        <translation>各段相接处曲率突变：已光顺，距所绘曲线最多 %1 mm；%2（Smooth = 0 或 --smooth 0 按所绘，数值越大越光顺）。</translation>
    </message>
    <message>
        <source>nothing was changed; take fewer planes, or try again</source>
        <translation>未作任何更改；减少平面数，或重试</translation>
    </message>
    <message>
        <source>select a body, a surface or a mesh to cut</source>
        <translation>请选择要切割的实体、曲面或网格</translation>
    </message>
    <message>
        <source>choose a family, an axis (X, Y or Z) and one plane or more</source>
        <translation>请选择平面族、轴（X、Y 或 Z）和至少一个平面</translation>
    </message>
    <message>
        <source>has construction geometry and points only</source>
        <translation>只有辅助几何和点</translation>
    </message>
    <message>
        <source>has external geometry only</source>
        <translation>只有外部几何</translation>
    </message>
    <message>
        <source>the curve is missing: choose a sketch or an edge in the property Curve</source>
        <translation>缺少曲线：请在属性 Curve 中选择草图或边</translation>
    </message>
    <message>
        <source>%1 %2: draw a spline in it</source>
        <translation>%1 %2：请在其中画一条样条</translation>
    </message>
    <message>
        <source>%1 is not plane</source>
        <translation>%1 不是平面的</translation>
    </message>
    <message>
        <source>%1 has no shape: choose a sketch, an edge or a wire</source>
        <translation>%1 没有形状：请选择草图、边或线框</translation>
    </message>
    <message>
        <source>%1 has many edges: choose the ones that the strip is to follow</source>
        <translation>%1 有许多边：请选择条带要跟随的边</translation>
    </message>
    <message>
        <source>%1 has no %2 any more: choose the curve anew</source>
        <translation>%1 已没有 %2：请重新选择曲线</translation>
    </message>
    <message>
        <source>there is nothing to write: choose kinds of files</source>
        <translation>没有要写的内容：请选择文件类型</translation>
    </message>
    <message>
        <source>%1 is no sketch: nothing can be drawn into it</source>
        <translation>%1 不是草图：无法绘入</translation>
    </message>
    <message>
        <source>there is nothing to cut: choose a body, a surface or a mesh in the property Sources</source>
        <translation>没有可切割的对象：请在属性 Sources 中选择实体、曲面或网格</translation>
    </message>
    <message>
        <source>the strip is missing: choose one in the property Strip</source>
        <translation>缺少条带：请在属性 Strip 中选择</translation>
    </message>
    <message>
        <source>the planes miss the object: move them, or take more</source>
        <translation>平面未与对象相交：移动平面或增加数量</translation>
    </message>
    <message>
        <source>no strip here has a tab to be held: give the strips tabs</source>
        <translation>这里没有可固定的插片：请给条带加插片</translation>
    </message>
    <message>
        <source>%1 does not belong to %2: choose its model, or none</source>
        <translation>%1 不属于 %2：请选择它的模型，或不选</translation>
    </message>
    <message>
        <source>%1 is not laminated: it has no backing; choose the layer Base</source>
        <translation>%1 不是层压的：没有背层；请选择 Base 层</translation>
    </message>
    <message>
        <source>the model has no strips: choose some in the property Strips</source>
        <translation>模型没有条带：请在属性 Strips 中选择</translation>
    </message>
    <message>
        <source>%1 makes its copies of %2 part of one body, and leaves out those that do not touch it: delete it, and repeat the strip by an array of the workbench Draft</source>
        <translation>%1 将 %2 的副本并入同一个实体，并略去不与之接触的副本：删除 %1，改用 Draft 工作台的阵列来重复该条带</translation>
    </message>
    <message>
        <source>%1 is scaled, and a strip of another size bends otherwise: set its Scale to 1</source>
        <translation>%1 已缩放，而尺寸不同的条带弯曲方式不同：将其 Scale 设为 1</translation>
    </message>
    <message>
        <source>a curve is %1 mm large; %2 to %3 mm are read: check the unit (--unit), or leave it out</source>
        <translation>曲线尺寸为 %1 mm；可读取 %2 到 %3 mm：请检查单位，或将其去掉</translation>
    </message>
    <message>
        <source>a coordinate is %1 mm; they must be finite and at most %2 mm: check the unit, or export it anew</source>
        <translation>某个坐标为 %1 mm；坐标必须有限且不超过 %2 mm：请检查单位，或重新导出</translation>
    </message>
    <message>
        <source>%1 is no strip: a model is made of strips</source>
        <translation>%1 不是条带：模型由条带组成</translation>
    </message>
    <message>
        <source>there is nothing to cut: select strips, models or base plates</source>
        <translation>没有可切割的对象：请选择条带、模型或底板</translation>
    </message>
    <message>
        <source>%1 links to %2 in %3, which is missing: put that file back or open it, and recompute the document</source>
        <translation>%1 链接到 %3 中的 %2，但该文件不存在：请将文件放回原处或打开它，然后重新计算文档</translation>
    </message>
    <message>
        <source>%1 links to what was deleted: choose another object in its property LinkedObject, or delete the link</source>
        <translation>%1 所链接的对象已被删除：请在属性 LinkedObject 中选择另一个对象，或删除该链接</translation>
    </message>
    <message>
        <source>%1 reads %2, which is missing: put that file back, or name another in its property FileName, and recompute the document</source>
        <translation>%1 读取的文件 %2 不存在：请将文件放回原处，或在属性 FileName 中指定另一个文件，然后重新计算文档</translation>
    </message>
    <message>
        <source>the formula of %1 cannot be computed (%2): mend it, or take it away</source>
        <translation>无法计算 %1 的公式（%2）：请更正或删除它</translation>
    </message>
    <message>
        <source>%1 has the formula %2, which gives %3: it takes 0 to %4, or a name such as %5; mend the formula, or take it away</source>
        <translation>%1 的公式 %2 得到 %3：可取 0 至 %4，或名称如 %5；请更正或删除该公式</translation>
    </message>
    <message>
        <source>%1 cannot be made (%2): mend it first</source>
        <translation>%1 无法生成（%2）：请先修复它</translation>
    </message>
    <message>
        <source>a curve %1 mm from this one</source>
        <translation>一条距此 %1 mm 的曲线</translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve.</source>
        <translation>平条带无法弯成这条曲线。</translation>
    </message>
    <message>
        <source>There is no strip.</source>
        <translation>没有条带。</translation>
    </message>
    <message>
        <source>(conjugate point at %1 mm)</source>
        <translation>（共轭点在 %1 mm）</translation>
    </message>
    <message>
        <source>it does not stay in this shape: the stability margin is %1%2</source>
        <translation>它不会保持此形状：稳定裕度为 %1%2</translation>
    </message>
    <message>
        <source>A flat strip takes %1%2.</source>
        <translation>平条带可以弯成%1%2。</translation>
    </message>
    <message>
        <source>the thickness of the sheet is %1 mm, less than any foil's: is its unit right?</source>
        <translation>板材厚度为 %1 mm，比任何箔都薄：单位是否正确？</translation>
    </message>
    <message>
        <source>%1 samples are asked for: %2 are the most, 0 chooses</source>
        <translation>要求 %1 个采样点：最多 %2 个，0 为自动</translation>
    </message>
    <message>
        <source>the direction of gravity is zero: give a vector such as (0, 0, -1)</source>
        <translation>重力方向为零：请给出如 (0, 0, -1) 的向量</translation>
    </message>
    <message>
        <source>%1 is %2 mm, more than a kilometre: is its unit right?</source>
        <translation>%1 为 %2 mm，超过一公里：单位是否正确？</translation>
    </message>
    <message>
        <source>the length of the curve</source>
        <translation>曲线长度</translation>
    </message>
    <message>
        <source>recompute to try again</source>
        <translation>重新计算以重试</translation>
    </message>
    <message>
        <source>%1: stopped; change the curve or the limits to try again</source>
        <translation>%1：已停止；更改曲线或限制后重试</translation>
    </message>
    <message>
        <source>FreeCAD's kernel cannot make this shape (%1): change the curve, the widths or the holes</source>
        <translation>FreeCAD 内核无法生成此形状（%1）：请更改曲线、宽度或孔</translation>
    </message>
    <message>
        <source>%1 is not installed in this FreeCAD: strips need numpy and scipy</source>
        <translation>此 FreeCAD 未安装 %1：条带需要 numpy 和 scipy</translation>
    </message>
    <message>
        <source>there is no sheet called %1 here: choose another one, or add it to the sheet library</source>
        <translation>没有名为 %1 的板材：请另选，或加入板材库</translation>
    </message>
    <message>
        <source>the sheet %1 kept in this document cannot be read: choose another one</source>
        <translation>无法读取本文档保存的板材 %1：请另选</translation>
    </message>
    <message>
        <source>%1 holds no sketch for a strip: draw a spline in a sketch of its own, or select the edge that the strip is to follow</source>
        <translation>%1 中没有可用于条带的草图：请在单独的草图中绘制样条，或选择条带要跟随的边</translation>
    </message>
    <message>
        <source>%1 holds several sketches (%2): select the one that the strip is to follow</source>
        <translation>%1 中有多个草图（%2）：请选择条带要跟随的那一个</translation>
    </message>
    <message>
        <source>A flat strip takes this curve: %1 wide, stiffness ratio %2, strain %3 % of what the sheet bears.</source>
        <translation>平条带可以弯成这条曲线：宽 %1，刚度比 %2，应变为板材承受值的 %3 %。</translation>
    </message>
    <message>
        <source>A strip bent beforehand takes this curve: %1 wide, stiffness ratio %2, strain %3 % of what the sheet bears.</source>
        <translation>预弯的条带可以弯成这条曲线：宽 %1，刚度比 %2，应变为板材承受值的 %3 %。</translation>
    </message>
    <message>
        <source>%1 is no reading: write overhang = droop in mm, such as 120 = 14.5; 150 = 31</source>
        <translation>%1 不是读数：请以 mm 写“悬伸 = 下垂”，例如 120 = 14.5; 150 = 31</translation>
    </message>
    <message>
        <source>Nearest curve to sketch</source>
        <translation>草图的最近曲线</translation>
    </message>
    <message>
        <source>there is no curve: draw a spline for the strip to follow</source>
        <translation>没有曲线：请画一条供条带跟随的样条</translation>
    </message>
    <message>
        <source>an edge runs on to infinity: trim it</source>
        <translation>有一条边无限长：请修剪</translation>
    </message>
    <message>
        <source>the shape cannot pass through a temporary file (%1): make that folder writable, with room in it</source>
        <translation>形状无法经临时文件传递（%1）：请使该文件夹可写且有空间</translation>
    </message>
    <message>
        <source>an edge is degenerate: it has no curve in space; choose another edge</source>
        <translation>有一条边退化：在空间中没有曲线；请另选</translation>
    </message>
    <message>
        <source>%1 inflection</source>
        <translation>%1 个拐点</translation>
    </message>
    <message>
        <source>%1 inflections</source>
        <translation>%1 个拐点</translation>
    </message>
    <message>
        <source>at %1 mm</source>
        <translation>在 %1 mm</translation>
    </message>
    <message>
        <source>at %1 and %2 mm</source>
        <translation>在 %1 和 %2 mm</translation>
    </message>
    <message>
        <source>The line through its inflections crosses the curve %1, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation>过其拐点的直线与曲线相交（%1），在那里弯矩必须为零或变号，而曲率不变：把曲线在该处移离直线，或在该处与旁边的拐点之间支撑条带。</translation>
    </message>
    <message>
        <source>The line through its inflections touches the curve %1, where the moment would vanish or change sign and the curvature does not: move the curve off the line there, or support the strip between there and the inflections beside it.</source>
        <translation>过其拐点的直线与曲线相切（%1），在那里弯矩必须为零或变号，而曲率不变：把曲线在该处移离直线，或在该处与旁边的拐点之间支撑条带。</translation>
    </message>
    <message>
        <source>between %1 and %2 mm</source>
        <translation>在 %1 与 %2 mm 之间</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>is straight</source>
        <translation>是直的</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>是空的</translation>
    </message>
    <message>
        <source>%1 edges in all</source>
        <translation>共 %1 条边</translation>
    </message>
    <message>
        <source>%1 has %2 chains of edges: choose the edges of one as the path</source>
        <translation>%1 有 %2 条边链：请选择其中一条的边作为路径</translation>
    </message>
    <message>
        <source>choose a path: a sketch or a wire that the planes stand across</source>
        <translation>请选择路径：平面所垂直的草图或线框</translation>
    </message>
    <message>
        <source>%1 mm along the path</source>
        <translation>沿路径 %1 mm 处</translation>
    </message>
    <message>
        <source>smoothing took waves shorter than %1 mm away; a shorter wavelength stays nearer</source>
        <translation>抹平去掉了短于 %1 mm 的波纹；更短的波长会更接近</translation>
    </message>
    <message>
        <source>no smooth curve came nearer; smooth the section first, with a wavelength</source>
        <translation>没有更接近的光滑曲线；请先用某一波长抹平截面</translation>
    </message>
    <message>
        <source>section %1</source>
        <translation>截面 %1</translation>
    </message>
    <message>
        <source>the nearest curve</source>
        <translation>最近曲线</translation>
    </message>
    <message>
        <source>can</source>
        <translation>可以</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>the curve has a corner %1%2, of %3 degrees: a strip bends without kinks; round it, or draw two curves%4</source>
        <translation>曲线%1%2 有 %3 度的拐角：条带弯曲无折角；请倒圆或画成两条曲线%4</translation>
    </message>
    <message>
        <source>, or take it out within %1 mm (smooth = %2, --smooth %3)</source>
        <translation>，或在 %1 mm 内消除它（smooth = %2，--smooth %3）</translation>
    </message>
    <message>
        <source>Its corners, of %1 degrees at most, were rounded within that.</source>
        <translation>其拐角（最大 %1 度）已在此范围内倒圆。</translation>
    </message>
    <message>
        <source>it is %1 mm wide and %2 mm long: what is wider than long bends as a plate, not as a strip; give a smaller max_width, and look at its unit</source>
        <translation>宽 %1 mm，长 %2 mm：宽大于长时按板弯曲，而不是条带；请给出较小的 max_width，并检查其单位</translation>
    </message>
    <message>
        <source>No force can act between its ends, so the moment is constant and the curve must bend one way only; it has %1, %2: hold both ends in x or in y.</source>
        <translation>两端之间没有力，弯矩为常数，曲线只能向一侧弯曲；它有%1，%2：请在 x 或 y 方向固定两端。</translation>
    </message>
    <message>
        <source>The bending is reversed by a jump of the curvature %1, where the stiffness would have to go to 0: support the strip there, or let the curvature pass through zero smoothly (smooth = 0.1, or --smooth 0.1, does that within 0.1 mm).</source>
        <translation>弯曲%1处因曲率突变而反向，那里刚度须为零：在该处支撑条带，或让曲率平滑过零（属性 Smooth = 0.1 可在 0.1 mm 内做到）。</translation>
    </message>
    <message>
        <source>%1, whatever supports the strip there: bend the piece a little.</source>
        <translation>%1，无论那里如何支撑：请把该段稍微弯曲。</translation>
    </message>
    <message>
        <source>%1: support the strip %2, or bend the piece a little.</source>
        <translation>%1：在%2支撑条带，或把该段稍微弯曲。</translation>
    </message>
    <message>
        <source>%1 rows are %2 mm long each: diamonds with bridges of %3 mm between their tips need more than %4 mm; use fewer rows</source>
        <translation>%1 行各长 %2 mm：尖端间留 %3 mm 桥的菱形需要超过 %4 mm；请减少行数</translation>
    </message>
    <message>
        <source>the rod's bending stiffness of %1 N mm2 asks for a backing wider than fits at %2 mm, where %3 N mm2 is the most: use thicker or stiffer sheets, or widen the base</source>
        <translation>杆的抗弯刚度 %1 N mm2 要求的背层在 %2 mm 处放不下，那里最大为 %3 N mm2：使用更厚或更硬的板材，或加宽基层</translation>
    </message>
    <message>
        <source>the rod's bending stiffness of %1 N mm2 leaves a backing narrower than %2 mm at %3 mm, where %4 N mm2 is the least: use thinner sheets, or narrow the base</source>
        <translation>杆的抗弯刚度 %1 N mm2 使 %3 mm 处背层窄于 %2 mm，那里最小为 %4 N mm2：使用更薄的板材，或收窄基层</translation>
    </message>
    <message>
        <source>ligaments lean %1 degrees off the strip at %2 mm: use fewer rows, %3 mm long or longer</source>
        <translation>在 %2 mm 处筋与条带倾斜 %1 度：减少行数，每行长 %3 mm 以上</translation>
    </message>
    <message>
        <source>the rod's bending stiffness asks for %1 mm of material at %2 mm, %3 mm fit: widen the outline or raise max_width</source>
        <translation>杆的抗弯刚度在 %2 mm 处需要 %1 mm 材料，只放得下 %3 mm：加宽轮廓或增大 MaterialWidth</translation>
    </message>
    <message>
        <source>the rod's bending stiffness asks for a width of %1 mm, above max_width %2 mm: choose a thicker or stiffer sheet</source>
        <translation>杆的抗弯刚度要求宽 %1 mm，超过 MaxWidth %2 mm：请选用更厚或更硬的板材</translation>
    </message>
    <message>
        <source>a curve leaves its plane by %1 mm (its z runs over %2 mm): a strip bends in one plane only; project the curve onto a plane first</source>
        <translation>曲线偏离其平面 %1 mm（z 跨 %2 mm）：条带只能在一个平面内弯曲；请先把曲线投影到平面</translation>
    </message>
    <message>
        <source>bends between false inflections were smoothed away</source>
        <translation>伪拐点之间的弯曲已被抹平</translation>
    </message>
    <message>
        <source>The strip would be %1 mm wide and %2 mm long: a strip bends as computed where it is %3 times as long as wide; draw a longer curve, or make the strip narrower.</source>
        <translation>条带将宽 %1 mm、长 %2 mm：长度为宽度的 %3 倍时才按计算弯曲；请画更长的曲线，或改窄条带。</translation>
    </message>
    <message>
        <source>a corner radius of %1 mm does not fit the hole at %2: make it smaller</source>
        <translation>%1 mm 的圆角半径不适合 %2 处的孔：请减小</translation>
    </message>
    <message>
        <source>a corner radius of %1 mm leaves %2 % too much material at the tips at %3 mm: %4 mm or less keeps it within %5 %</source>
        <translation>%1 mm 的圆角半径在 %3 mm 处尖端多留 %2 % 材料：%4 mm 以下可保持在 %5 % 以内</translation>
    </message>
    <message>
        <source>strain %1 % at %2 mm is beyond the %3 % that %4 bears: its radius there is %5 mm, the least advisable %6 mm; %7; use a thinner sheet or a gentler curve</source>
        <translation>%2 mm 处应变 %1 % 超过 %4 可承受的 %3 %：那里半径为 %5 mm，建议最小 %6 mm；%7；使用更薄的板材或更平缓的曲线</translation>
    </message>
    <message>
        <source>strain %1 % at %2 mm is beyond the %3 % that %4 bears: its radius there is %5 mm, the least advisable %6 mm; %7; use a thinner sheet or a gentler curve.</source>
        <translation>%2 mm 处应变 %1 % 超过 %4 可承受的 %3 %：那里半径为 %5 mm，建议最小 %6 mm；%7；使用更薄的板材或更平缓的曲线。</translation>
    </message>
    <message>
        <source>it may crack there, or keep a bend</source>
        <translation>那里可能开裂，或留下弯曲</translation>
    </message>
    <message>
        <source>it creeps there and keeps a part of its bend</source>
        <translation>那里会蠕变并保留部分弯曲</translation>
    </message>
    <message>
        <source>it keeps a bend from there</source>
        <translation>那里会留下弯曲</translation>
    </message>
    <message>
        <source>it may crack there</source>
        <translation>那里可能开裂</translation>
    </message>
    <message>
        <source>a tab has either a corner radius or a chamfer, not both</source>
        <translation>插片只能有圆角或倒角之一</translation>
    </message>
    <message>
        <source>a tab that tapers has neither corner radius nor chamfer</source>
        <translation>有锥度的插片不能有圆角或倒角</translation>
    </message>
    <message>
        <source>Missed: the %1, by %2 mm.</source>
        <translation>未满足：%1，相差 %2 mm。</translation>
    </message>
    <message>
        <source>Missed: the %1, by %2 degrees.</source>
        <translation>未满足：%1，相差 %2 度。</translation>
    </message>
    <message>
        <source>Missed: the %1.</source>
        <translation>未满足：%1。</translation>
    </message>
    <message>
        <source>The least radius of %1 mm is missed: this rod has %2 mm.</source>
        <translation>未达到最小半径 %1 mm：该杆为 %2 mm。</translation>
    </message>
    <message>
        <source>a least radius of %1 instead of %2 mm</source>
        <translation>最小半径 %1 而不是 %2 mm</translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2 mm at %3, a corner to any strip: %4, or smooth it</source>
        <translation>%1 在 %3 处弯曲半径为 %2 mm，对任何条带都是拐角：%4，或使其光顺</translation>
    </message>
    <message>
        <source>It would break at %1 mm: its radius there is %2 mm, the sheet bears %3 mm; use a thinner sheet or a gentler curve.</source>
        <translation>会在 %1 mm 处断裂：那里半径为 %2 mm，板材可承受 %3 mm；使用更薄的板材或更平缓的曲线。</translation>
    </message>
    <message>
        <source>It is strained beyond its limit at %1 mm: its radius there is %2 mm, the sheet bears %3 mm; %4; use a thinner sheet or a gentler curve.</source>
        <translation>它在 %1 mm 处的应变超过极限：那里半径为 %2 mm，板材可承受 %3 mm；%4；使用更薄的板材或更平缓的曲线。</translation>
    </message>
    <message>
        <source>The curvature runs out to zero %1 without a clear change of sign, where the stiffness would have to be infinite or zero, whatever supports the strip: bend the curve a little more there, or reverse its bending at a clear rate.</source>
        <translation>曲率%1处趋于零而没有明确变号，无论如何支撑，那里的刚度都须为无穷或零：请在那里稍多弯一些，或以明确的速率反向弯曲。</translation>
    </message>
    <message>
        <source>The line through its inflections %1</source>
        <translation>过其拐点的直线%1</translation>
    </message>
    <message>
        <source>A flat strip would break on this curve.</source>
        <translation>平条会在这条曲线上断裂。</translation>
    </message>
    <message>
        <source>A flat strip takes this curve.</source>
        <translation>平条带可以弯成这条曲线。</translation>
    </message>
    <message>
        <source>A flat strip takes a curve %1 mm from this one.</source>
        <translation>平条带可以弯成一条距此 %1 mm 的曲线。</translation>
    </message>
    <message>
        <source>A strip bent beforehand takes this curve.</source>
        <translation>预弯的条带可以弯成这条曲线。</translation>
    </message>
    <message>
        <source>A strip bent beforehand cannot take this curve.</source>
        <translation>预弯的条带无法弯成这条曲线。</translation>
    </message>
    <message>
        <source>A strip bent beforehand would break on this curve.</source>
        <translation>预弯的条带会在这条曲线上断裂。</translation>
    </message>
    <message>
        <source>A strip bent beforehand takes a curve %1 mm from this one.</source>
        <translation>预弯的条带可以弯成一条距此 %1 mm 的曲线。</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm all along, the way it stands bent at %2 mm: its widths count on that</source>
        <translation>安装前先将其全长预弯成半径 %1 mm，弯向与它装好后在 %2 mm 处的弯向相同：其宽度已按此计算</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm all along, the other way than it stands bent at %2 mm: its widths count on that</source>
        <translation>安装前先将其全长预弯成半径 %1 mm，弯向与它装好后在 %2 mm 处的弯向相反：其宽度已按此计算</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm at %2 mm, its sharpest, the way it stands bent there: its widths count on that; `blank` in the report has its curvature along the strip</source>
        <translation>安装前先将其预弯，最急处在 %2 mm，半径 %1 mm，弯向与它装好后在该处的弯向相同：其宽度已按此计算；沿条带的曲率见属性 Blank</translation>
    </message>
    <message>
        <source>bend it beforehand to a radius of %1 mm at %2 mm, its sharpest, the other way than it stands bent there: its widths count on that; `blank` in the report has its curvature along the strip</source>
        <translation>安装前先将其预弯，最急处在 %2 mm，半径 %1 mm，弯向与它装好后在该处的弯向相反：其宽度已按此计算；沿条带的曲率见属性 Blank</translation>
    </message>
    <message>
        <source>bend it beforehand to %1, %2 it stands bent %3: its widths count on that%4</source>
        <translation>安装前先将其预弯成%1，%2它装好后%3的弯向：其宽度已按此计算%4</translation>
    </message>
    <message>
        <source>a radius of %1 mm</source>
        <translation>半径 %1 mm</translation>
    </message>
    <message>
        <source>%1 %2, its sharpest</source>
        <translation>%1（%2，最急处）</translation>
    </message>
    <message>
        <source>the other way than</source>
        <translation>弯向相反于</translation>
    </message>
    <message>
        <source>; `blank` in the report has its curvature along the strip</source>
        <translation>；沿条带的曲率见属性 Blank</translation>
    </message>
    <message>
        <source>There are remarks.</source>
        <translation>有备注。</translation>
    </message>
    <message>
        <source>A flat strip cannot take this curve</source>
        <translation>平条带无法弯成这条曲线</translation>
    </message>
    <message>
        <source>The nearest curve is %1 mm away.</source>
        <translation>最近曲线距此 %1 mm。</translation>
    </message>
    <message>
        <source>It moves by %1 mm at most</source>
        <translation>最多移动 %1 mm</translation>
    </message>
    <message>
        <source>%1 and %2; its stability margin is %3.</source>
        <translation>%1，%2；稳定裕度为 %3。</translation>
    </message>
    <message>
        <source>does not stay</source>
        <translation>不会保持</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>会保持</translation>
    </message>
    <message>
        <source>the slot of %1</source>
        <translation>%1 的槽</translation>
    </message>
    <message>
        <source>only %1 mm %2%3%4, %5 mm are needed in %6</source>
        <translation>%2%3%4仅 %1 mm，%6 需要 %5 mm</translation>
    </message>
    <message>
        <source>%1: a wall of %2 mm is too thin to print: make it %3 mm or more</source>
        <translation>%1：%2 mm 的壁太薄，无法打印：请不小于 %3 mm</translation>
    </message>
    <message>
        <source>%1: the slots of %2 and %3 run into each other near (%4, %5): give the strips narrower tabs or move them apart</source>
        <translation>%1：%2 与 %3 的槽在 (%4, %5) 附近相连：改窄插片，或移开</translation>
    </message>
    <message>
        <source>fit of the drawing</source>
        <translation>图形的拟合</translation>
    </message>
    <message>
        <source>%1 %2 pieces at %3 mm, joined by plates of %4 mm, which are stiffer and move the shape by %5 mm</source>
        <translation>%1 %2 段，接于 %3 mm，用 %4 mm 的搭板连接，搭板较硬，使形状移动 %5 mm</translation>
    </message>
    <message>
        <source>%1: a lap of %2 mm: give a length above 0 and below a third of %3 mm</source>
        <translation>%1：搭接 %2 mm：请给出大于 0 且小于 %3 mm 三分之一的长度</translation>
    </message>
    <message>
        <source>%1: strips of a law are not cut in pieces, for their plates would have to taper too: take a larger stock, or a strip of one sheet</source>
        <translation>%1：按规律变化的条带不分段，因为搭板也须渐变：使用更大的板料，或单层条带</translation>
    </message>
    <message>
        <source>%1 pieces: %2, joined by plates of %3 mm on the free face of each layer, which are stiffer and move the shape by %4 mm</source>
        <translation>%1 若干段：%2，在每层的外露面用 %3 mm 的搭板连接，搭板较硬，使形状移动 %4 mm</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 位于 %2 mm</translation>
    </message>
    <message>
        <source>%1 %2 pieces at %3 mm, joined by plates of %4 mm, without the %5 holes that lie under them; they are stiffer and move the shape by %6 mm</source>
        <translation>%1 %2 段，接于 %3 mm，用 %4 mm 的搭板连接，搭板下的 %5 个孔不切；搭板较硬，使形状移动 %6 mm</translation>
    </message>
    <message>
        <source>%1: there is no room for %2 joints of %3 mm between its slots: take a shorter lap or a larger stock</source>
        <translation>%1：槽之间放不下 %2 个 %3 mm 的接头：请缩短搭接或使用更大的板料</translation>
    </message>
    <message>
        <source>it bends to a radius of %1 mm at %2 mm, but plywood of %3 mm bends to %4 mm at least %5 the face grain (%6); use a thinner sheet or a gentler curve</source>
        <translation>它在 %2 mm 处弯曲半径为 %1 mm，但 %3 mm 胶合板%5面层纹理最小只能弯到 %4 mm（%6）；使用更薄的板材或更平缓的曲线</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 至 %2 mm</translation>
    </message>
    <message>
        <source>%1 mm long, %2</source>
        <translation>长 %1 mm，%2</translation>
    </message>
    <message>
        <source>give a smaller max_width, or name a larger stock</source>
        <translation>给出更小的最大宽度（max_width），或使用更大的板料</translation>
    </message>
    <message>
        <source>name a larger stock, join a strip of pieces by plates (lap), or scale the curve</source>
        <translation>使用更大的板料，用搭板把条带分段连接，或缩小曲线</translation>
    </message>
    <message>
        <source>the grain runs along x, the side of %1 mm</source>
        <translation>纹理沿 x 方向，即 %1 mm 的一边</translation>
    </message>
    <message>
        <source>sideways margin %1 (%2): %3</source>
        <translation>侧向裕度 %1（%2）：%3</translation>
    </message>
    <message>
        <source>sideways %1: %2</source>
        <translation>侧向%1：%2</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>low</source>
        <translation>偏低</translation>
    </message>
    <message>
        <source>ample</source>
        <translation>充足</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>未定</translation>
    </message>
    <message>
        <source>it tips over sideways or twists out of its plane: guide it at the sides, or make it wider</source>
        <translation>条带会侧倾或扭出其平面：请从两侧加以引导，或加宽条带</translation>
    </message>
    <message>
        <source>it stays in its plane, but a push from the side may tip it: guide it at the sides</source>
        <translation>条带留在其平面内，但侧面一推就可能使其倾倒：请从两侧加以引导</translation>
    </message>
    <message>
        <source>it stays in its plane</source>
        <translation>条带留在其平面内</translation>
    </message>
    <message>
        <source>too wide for its length and bend to be judged as a rod: try it out</source>
        <translation>相对其长度和弯曲程度过宽，不能按杆件判断：请实际试验</translation>
    </message>
    <message>
        <source>its holes leave open whether it tips over sideways: guide it at the sides, or try it out</source>
        <translation>因其孔洞，是否侧倾尚不能确定：请从两侧加以引导，或实际试验</translation>
    </message>
    <message>
        <source>%1 leaves its tabs no play: they bend a little between its edges</source>
        <translation>%1没有给插片留余隙：插片在其边缘之间略微弯曲</translation>
    </message>
    <message>
        <source>%1 leaves its tabs %2 mm across and %3 to %4 degrees</source>
        <translation>%1给插片留有横向 %2 mm、转动 %3 至 %4 度的余隙</translation>
    </message>
    <message>
        <source>slot of %1</source>
        <translation>%1 的槽</translation>
    </message>
    <message>
        <source>pocket</source>
        <translation>夹块槽</translation>
    </message>
    <message>
        <source>%1 at %2 mm also runs %3 mm deep into %4 at %5 mm, beside the slots that join them, near (%6, %7, %8) mm%9: turn or shift one of them, or make them narrower there</source>
        <translation>%1 在 %2 mm 处还伸入 %4 的 %5 mm 处 %3 mm 深，位于连接两者的槽口之外，靠近 (%6, %7, %8) mm%9：请转动或移动其中一条，或在该处减小宽度</translation>
    </message>
    <message>
        <source>%1 at %2 mm lies in the thickness of %3 at %4 mm%5: place them apart, or make them narrower there</source>
        <translation>%1 在 %2 mm 处位于 %3 的 %4 mm 处的厚度之内%5：请把它们分开，或在该处减小宽度</translation>
    </message>
    <message>
        <source>%1 at %2 mm runs through %3 at %4 mm%5: slot them (interlock), place them apart, or make them narrower there</source>
        <translation>%1 在 %2 mm 处穿过 %3 的 %4 mm 处%5：请开槽（Interlock）、把它们分开，或在该处减小宽度</translation>
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
        <source>Keep as my sheet</source>
        <translation>存为我的板材</translation>
    </message>
    <message>
        <source>Remove my sheet</source>
        <translation>删除我的板材</translation>
    </message>
    <message>
        <source>All sheets that are known, yours first</source>
        <translation>所有已知板材，您的在前</translation>
    </message>
    <message>
        <source>Name under which your sheet is kept</source>
        <translation>保存板材所用的名称</translation>
    </message>
    <message>
        <source>As measured with a caliper</source>
        <translation>用卡尺测量</translation>
    </message>
    <message>
        <source>Stiffness of the material along the strip; a coupon measures it</source>
        <translation>材料沿条带方向的刚度；可用试条测量</translation>
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
        <source>Width that your machine cuts away</source>
        <translation>机器切去的宽度</translation>
    </message>
    <message>
        <source>How much it narrows while it is stretched, a share</source>
        <translation>拉伸时变窄的比例</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>数据来源</translation>
    </message>
    <message>
        <source>Adds these numbers to your library under the name above</source>
        <translation>以上述名称把这些数据加入库</translation>
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
        <source>Bends for each cause</source>
        <translation>每种原因的弯曲次数</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>How many varied strips are bent</source>
        <translation>弯曲的变化条带数量</translation>
    </message>
    <message>
        <source>Bends them all; Escape stops it</source>
        <translation>全部弯曲；按 Esc 停止</translation>
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
        <source>Draw the curve that a strip of given length takes between two clamps into the open sketch; pull its ends</source>
        <translation>在打开的草图中绘制给定长度的条带在两个夹具之间呈现的曲线，并拖动其端点</translation>
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
        <source>Say whether a flat strip can take the selected curve, and if not why and where</source>
        <translation>判断平条带能否弯成所选曲线；若不能，说明原因和位置</translation>
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
        <source>Make printed blocks that hold the ends of the selected strips or model, or one slotted base plate</source>
        <translation>为所选条带或模型的端部生成打印夹具，或一块开槽底板</translation>
    </message>
</context>
<context>
    <name>Elastica_Interlock</name>
    <message>
        <source>Interlock selected strips</source>
        <translation>互锁所选条带</translation>
    </message>
    <message>
        <source>Put the selected strips together to a model and cut slots where they cross</source>
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
        <source>Give the selected strips an even width and glue narrower strips on that make them stiff enough</source>
        <translation>使所选条带等宽，并粘贴较窄的条带以获得足够刚度</translation>
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
        <translation>在打开的草图上方显示平条能否弯成其曲线，绘制和拖动时实时更新</translation>
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
        <source>Lay everything that must be cut for the selected strips, models and base plates on sheets</source>
        <translation>将所选条带、模型和底板的全部切割件排布到板材上</translation>
    </message>
</context>
<context>
    <name>Elastica_Perforate</name>
    <message>
        <source>Perforate</source>
        <translation>打孔</translation>
    </message>
    <message>
        <source>Give the selected strips an even width and let holes make them as soft as they must be</source>
        <translation>使所选条带等宽，并用孔使其达到所需柔度</translation>
    </message>
</context>
<context>
    <name>Elastica_Projective</name>
    <message>
        <source>Projective edit</source>
        <translation>射影编辑</translation>
    </message>
    <message>
        <source>Pull the selected sketch's curve by four handles: lines stay lines, a curve that can be bent stays one</source>
        <translation>用四个手柄拉动所选草图的曲线：直线保持为直线，可弯曲的曲线仍可弯曲</translation>
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
        <source>Look at the sheets that are known, with their sources, and keep your own</source>
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
        <source>Make the flat strip that bends into the selected spline: the bent part and, linked to it, the flat one</source>
        <translation>生成可弯成所选样条的平条带：弯曲零件及与之链接的平展零件</translation>
    </message>
</context>
<context>
    <name>Elastica_Tolerance</name>
    <message>
        <source>Tolerance study</source>
        <translation>公差研究</translation>
    </message>
    <message>
        <source>Find how far the bent strip strays when sheet, cut and clamps vary within their ranges</source>
        <translation>研究板材、切割和夹持在其范围内变化时弯曲条带的偏差</translation>
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
        <translation>弯成所绘曲线的平条</translation>
    </message>
</context>
</TS>
