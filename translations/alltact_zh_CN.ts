<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Figures</name>
    <message>
        <source>Depth&apos;s sd (mm)</source>
        <translation>深度标准差 (mm)</translation>
    </message>
    <message>
        <source>Pressed depth (mm)</source>
        <translation>压入深度 (mm)</translation>
    </message>
    <message>
        <source>Press depth, %1 (mm)</source>
        <translation>按压深度，%1 (mm)</translation>
    </message>
    <message>
        <source>along the normal</source>
        <translation>沿 z</translation>
    </message>
    <message>
        <source>projected</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Mapping minus ball (mm)</source>
        <translation>映射减球 (mm)</translation>
    </message>
    <message>
        <source>Error of the press (mm)</source>
        <translation>按压的误差 (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyModel</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Time of a picture (ms)</source>
        <translation>每张图像的时间 (ms)</translation>
    </message>
    <message>
        <source>Depth error, half within (mm)</source>
        <translation>深度误差，一半在内 (mm)</translation>
    </message>
    <message>
        <source>Depth error, 95 % within (mm)</source>
        <translation>深度误差，95 % 在内 (mm)</translation>
    </message>
    <message>
        <source>Place error, half within (mm)</source>
        <translation>位置误差，一半在内 (mm)</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>评价</translation>
    </message>
    <message>
        <source>best for its time</source>
        <translation>同样时间内最好</translation>
    </message>
    <message>
        <source>worse than: %1</source>
        <translation>不如：%1</translation>
    </message>
    <message>
        <source>not in every picture</source>
        <translation>并非每张图像都有</translation>
    </message>
    <message>
        <source>in use now; %1</source>
        <translation>正在使用；%1</translation>
    </message>
    <message>
        <source>what it loses is not in these pictures</source>
        <translation>它的损失在这些图像中看不出</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyPage</name>
    <message>
        <source>How fast must it be, and what error may it have? What settings cost in time and bring in accuracy is measured once on this finger&apos;s own pictures; then one answer stands here.</source>
        <translation>要多快，又允许多大误差？用此手指自己的图像测量一次各项设置所花的时间和带来的精度，之后这里会给出一个答案。</translation>
    </message>
    <message>
        <source>&amp;Measure what settings cost on this finger (about 12 s)</source>
        <translation>测量各项设置在此手指上的代价（约 12 秒）(&amp;M)</translation>
    </message>
    <message>
        <source>How many pictures per &amp;second?</source>
        <translation>每秒多少张图像？(&amp;S)</translation>
    </message>
    <message>
        <source>How many pictures per second?</source>
        <translation>每秒多少张图像？</translation>
    </message>
    <message>
        <source>What er&amp;ror may it have?</source>
        <translation>允许多大误差？(&amp;R)</translation>
    </message>
    <message>
        <source>What error may it have?</source>
        <translation>允许多大误差？</translation>
    </message>
    <message>
        <source>Of depth, where 95 % of all points lie within.</source>
        <translation>深度误差，95 % 的位置在此范围内。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>as small as fits</source>
        <translation>尽可能小</translation>
    </message>
    <message>
        <source>As cali&amp;brated again</source>
        <translation>恢复标定时的设置(&amp;B)</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>Copy &amp;command</source>
        <translation>复制命令(&amp;C)</translation>
    </message>
    <message>
        <source>The same as a command line</source>
        <translation>相同操作的命令行</translation>
    </message>
    <message>
        <source>Progress of measuring</source>
        <translation>测量进度</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>停止(&amp;P)</translation>
    </message>
    <message>
        <source>What was measured is kept; measuring goes on there another time.</source>
        <translation>已测得的会保留，下次从那里继续。</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>&amp;Accuracy</source>
        <translation>精度(&amp;A)</translation>
    </message>
    <message>
        <source>as calibrated</source>
        <translation>与标定时相同</translation>
    </message>
    <message>
        <source>%1 ms a picture; depth: half of all points within %2 mm, 95 % within %3 mm</source>
        <translation>每张图像 %1 ms；深度：一半位置在 %2 mm 内，95 % 在 %3 mm 内</translation>
    </message>
    <message>
        <source>In use now.</source>
        <translation>正在使用。</translation>
    </message>
    <message>
        <source>Other than now: %1</source>
        <translation>与现在不同：%1</translation>
    </message>
    <message>
        <source>%1 ms faster than now</source>
        <translation>比现在快 %1 ms</translation>
    </message>
    <message>
        <source>%1 ms slower than now</source>
        <translation>比现在慢 %1 ms</translation>
    </message>
    <message>
        <source>%1 mm closer than now</source>
        <translation>比现在准 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm further off than now</source>
        <translation>比现在差 %1 mm</translation>
    </message>
    <message>
        <source>Open a finger first.</source>
        <translation>请先打开手指。</translation>
    </message>
    <message>
        <source>The finger is being read.</source>
        <translation>正在读取手指。</translation>
    </message>
    <message>
        <source>Calibrate this finger first.</source>
        <translation>请先标定此手指。</translation>
    </message>
    <message>
        <source>Record this finger&apos;s reference first.</source>
        <translation>请先录制此手指的参考。</translation>
    </message>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>大约还需 %n 秒</numerusform>
        </translation>
    </message>
    <message>
        <source>measuring what settings cost…</source>
        <translation>正在测量各项设置的代价…</translation>
    </message>
    <message>
        <source>The finger has changed since this was measured: measure again.</source>
        <translation>此次测量之后手指已改变：请重新测量。</translation>
    </message>
    <message>
        <source>Measured on another computer (%1): its errors hold, its times do not.</source>
        <translation>在另一台计算机 (%1) 上测得：误差有效，时间无效。</translation>
    </message>
    <message>
        <source>Measuring was stopped: some settings are missing.</source>
        <translation>测量已停止：缺少一些设置。</translation>
    </message>
    <message>
        <source>Chosen by hand. Esc in the figure returns to the answer.</source>
        <translation>手动选择。在图中按 Esc 返回答案。</translation>
    </message>
    <message>
        <source>The most accurate of all that take at most %1 ms.</source>
        <translation>所有不超过 %1 ms 的设置中最准的。</translation>
    </message>
    <message>
        <source>The fastest that keeps 95 % of all points within %1 mm.</source>
        <translation>使 95 % 的位置保持在 %1 mm 内的最快设置。</translation>
    </message>
    <message>
        <source>No setting keeps %1 mm. This is the most accurate that takes at most %2 ms.</source>
        <translation>没有设置能保持 %1 mm。这是不超过 %2 ms 的设置中最准的。</translation>
    </message>
    <message>
        <source>Keeping %1 mm allows %2 pictures per second. This is the most accurate that is fast enough.</source>
        <translation>保持 %1 mm 时每秒可达 %2 张图像。这是足够快的设置中最准的。</translation>
    </message>
    <message>
        <source>No setting is so fast on this computer. This is the fastest: %1 pictures per second.</source>
        <translation>在这台计算机上没有这么快的设置。这是最快的：每秒 %1 张图像。</translation>
    </message>
    <message>
        <source>No setting measures this finger&apos;s pictures.</source>
        <translation>没有设置能测量此手指的图像。</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>正在使用</translation>
    </message>
    <message>
        <source>&amp;Use it</source>
        <translation>使用(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Measure again (about 12 s)</source>
        <translation>重新测量（约 12 秒）(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Measure what is missing</source>
        <translation>测量缺少的部分(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Measure pairs of settings, too</source>
        <translation>也测量成对的设置(&amp;M)</translation>
    </message>
    <message>
        <source>Live, side by side</source>
        <translation>实时并排</translation>
    </message>
    <message>
        <source>Figure, table or the live picture with two settings</source>
        <translation>图、表格，或用两种设置的实时图像</translation>
    </message>
    <message>
        <source>What it loses is not in these pictures, whose light is that of the recording.</source>
        <translation>它的损失在这些图像中看不出，因为图像的光照就是录像时的光照。</translation>
    </message>
    <message>
        <source>place: half within %1 mm</source>
        <translation>位置：一半在 %1 mm 内</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyPlot</name>
    <message>
        <source>What accuracy costs in time</source>
        <translation>精度所需的时间</translation>
    </message>
    <message>
        <source>Nothing has been measured yet</source>
        <translation>尚未测量</translation>
    </message>
    <message>
        <source>No setting is chosen</source>
        <translation>未选择设置</translation>
    </message>
    <message>
        <source>Time of a picture on this computer (ms)</source>
        <translation>在这台计算机上每张图像的时间 (ms)</translation>
    </message>
    <message>
        <source>Error of depth (mm)</source>
        <translation>深度误差 (mm)</translation>
    </message>
    <message>
        <source>slower or worse than another</source>
        <translation>比别的更慢或更差</translation>
    </message>
    <message numerus="yes">
        <source>%n slower or worse, beyond this figure</source>
        <translation>
            <numerusform>%n 个更慢或更差，在图外</numerusform>
        </translation>
    </message>
    <message>
        <source>best for its time; whisker up to 95 %</source>
        <translation>同样时间内最好；竖线至 95 %</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>已选</translation>
    </message>
    <message>
        <source>in use now</source>
        <translation>正在使用</translation>
    </message>
    <message>
        <source>%1 pictures per second</source>
        <translation>每秒 %1 张图像</translation>
    </message>
    <message>
        <source>%1: at %2 ms, further right →</source>
        <translation>%1：在 %2 ms 处，更靠右 →</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyTable</name>
    <message>
        <source>S&amp;ort by</source>
        <translation>排序依据(&amp;O)</translation>
    </message>
    <message>
        <source>Sort by</source>
        <translation>排序依据</translation>
    </message>
    <message>
        <source>What accuracy costs in time, as a table</source>
        <translation>精度所需的时间（表格）</translation>
    </message>
</context>
<context>
    <name>alltact::AgeLabel</name>
    <message>
        <source>Age of the picture</source>
        <translation>图像延迟</translation>
    </message>
    <message>
        <source>pictures without times</source>
        <translation>图像没有时间</translation>
    </message>
    <message>
        <source>picture %1 s old</source>
        <translation>图像延迟 %1 s</translation>
    </message>
    <message>
        <source>picture %1 ms old</source>
        <translation>图像延迟 %1 ms</translation>
    </message>
    <message>
        <source>What moves is seen late. Close other programs, or choose a faster setting in Accuracy.</source>
        <translation>运动显示有延迟。请关闭其他程序，或在“精度”中选择更快的设置。</translation>
    </message>
</context>
<context>
    <name>alltact::CalibratePage</name>
    <message>
        <source>&amp;Next: %1</source>
        <translation>下一步：%1(&amp;N)</translation>
    </message>
    <message>
        <source>This finger is not calibrated yet, so that no depth is shown.</source>
        <translation>此手指尚未标定，因此不显示深度。</translation>
    </message>
    <message>
        <source>Calibrate it with ball presses.</source>
        <translation>请用钢球按压进行标定。</translation>
    </message>
    <message>
        <source>&amp;Go to Calibrate</source>
        <translation>转到标定(&amp;G)</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>标定(&amp;C)</translation>
    </message>
</context>
<context>
    <name>alltact::CalibrationRun</name>
    <message>
        <source>calibrate</source>
        <translation>标定</translation>
    </message>
</context>
<context>
    <name>alltact::CheckPage</name>
    <message>
        <source>Three presses</source>
        <translation>三次按压</translation>
    </message>
    <message>
        <source>Is it still what it was?</source>
        <translation>它还和原来一样吗？</translation>
    </message>
    <message>
        <source>Press the ball of the calibration in at three places, base, middle and tip, and take a picture of each. The calibration stays as it is.</source>
        <translation>用标定时的球在根部、中部和指尖三处压入，各拍一张。标定保持不变。</translation>
    </message>
    <message>
        <source>&amp;Take a press (Space)</source>
        <translation>拍摄按压（空格）(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Begin again</source>
        <translation>重新开始(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Check now</source>
        <translation>立即检查(&amp;C)</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>检查进度</translation>
    </message>
    <message>
        <source>There is no live picture: choose a source.</source>
        <translation>没有实时画面：请选择来源。</translation>
    </message>
    <message>
        <source>The finger is not calibrated.</source>
        <translation>手指尚未标定。</translation>
    </message>
    <message>
        <source>The check is being made.</source>
        <translation>正在检查。</translation>
    </message>
    <message>
        <source>take a press for the check</source>
        <translation>为检查拍摄按压</translation>
    </message>
    <message>
        <source>check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Not checked yet</source>
        <translation>尚未检查</translation>
    </message>
    <message>
        <source>%1 of %2 taken.</source>
        <translation>已拍摄 %1 / %2。</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Press %1</source>
        <translation>按压 %1</translation>
    </message>
    <message>
        <source>begin the check again</source>
        <translation>重新开始检查</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>已排除：%1</translation>
    </message>
    <message>
        <source>The last check, on %1, was of a calibration before this one.</source>
        <translation>上次检查（%1）针对的是此前的标定。</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es) taken: enough.</source>
        <translation>
            <numerusform>已采集 %n 次按压：足够了。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Checked last on %1 with %n press(es): %2 mm off (passes up to %3 mm).</source>
        <translation>
            <numerusform>上次检查：%1，%n 次按压，偏差 %2 mm（不超过 %3 mm 即通过）。</numerusform>
        </translation>
    </message>
    <message>
        <source>A check needs %1 presses at different positions: press again.</source>
        <translation>检查需要 %1 次位置不同的按压：请再次按压。</translation>
    </message>
</context>
<context>
    <name>alltact::ContactWords</name>
    <message>
        <source>Touched on the contact face</source>
        <translation>接触面被触碰</translation>
    </message>
    <message>
        <source>Pushed from the back</source>
        <translation>从背面被推</translation>
    </message>
    <message>
        <source>Pushed from the upper side</source>
        <translation>从上侧面被推</translation>
    </message>
    <message>
        <source>Pushed from the lower side</source>
        <translation>从下侧面被推</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>已持续 %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>纵向</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>横向</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>± %1°</source>
        <translation>± %1°</translation>
    </message>
    <message>
        <source>(the face&apos;s normal)</source>
        <translation>（面的法线）</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3</source>
        <translation>x %1，y %2，z %3</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Area %1 mm², volume %2 mm³.</source>
        <translation>面积 %1 mm²，体积 %2 mm³。</translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s) on the face.</source>
        <translation>
            <numerusform>表面上有 %n 处接触。</numerusform>
        </translation>
    </message>
    <message>
        <source>It slips or rolls over the skin.</source>
        <translation>它在表皮上打滑或滚动。</translation>
    </message>
    <message>
        <source>Not known without a reference recording.</source>
        <translation>没有参考录像，无法得知。</translation>
    </message>
    <message>
        <source>Nothing touches the finger.</source>
        <translation>没有东西触碰手指。</translation>
    </message>
    <message>
        <source>The last contact lasted %1 and ended %2 ago.</source>
        <translation>上一次接触持续了 %1，于 %2 前结束。</translation>
    </message>
    <message>
        <source>It slipped.</source>
        <translation>期间有打滑。</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Along: over the face from its base. Across: from its middle line towards +y. Direction: the way the finger gave, in the camera&apos;s frame; its standard deviation is that within the finger&apos;s section.</source>
        <translation>纵向：沿面从根部算起。横向：从面的中线向 +y 方向。方向：手指退让的方向，以相机坐标系表示；其标准差是手指横截面内的标准差。</translation>
    </message>
</context>
<context>
    <name>alltact::ControlPanel</name>
    <message>
        <source>Automatic exposure</source>
        <translation>自动曝光</translation>
    </message>
    <message>
        <source>Exposure time</source>
        <translation>曝光时间</translation>
    </message>
    <message>
        <source>Automatic gain</source>
        <translation>自动增益</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Automatic white balance</source>
        <translation>自动白平衡</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>白平衡</translation>
    </message>
    <message>
        <source>Automatic focus</source>
        <translation>自动对焦</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>对焦</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source> K</source>
        <translation> K</translation>
    </message>
    <message>
        <source>Locked: unlock above to change it.</source>
        <translation>已锁定：请在上方解锁后再改。</translation>
    </message>
    <message>
        <source>An automatic mode has it in hand.</source>
        <translation>正由自动模式控制。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>&amp;Lock brightness</source>
        <translation>锁定亮度(&amp;L)</translation>
    </message>
    <message>
        <source>Automatic modes stay off, and what changes by itself is put back.</source>
        <translation>自动模式保持关闭，自行变化的设置会被恢复。</translation>
    </message>
    <message>
        <source>Brightness is the measurement: locked, nothing changes it. Unlock it before calibrating only.</source>
        <translation>亮度就是测量值：锁定后不会改变。仅在标定之前解锁。</translation>
    </message>
    <message>
        <source>A camera&apos;s exposure, gain, white balance and focus stand here. This source is no camera.</source>
        <translation>相机的曝光、增益、白平衡和对焦显示在这里。当前来源不是相机。</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (USB port %2)</source>
        <translation>%1（USB 端口 %2）</translation>
    </message>
</context>
<context>
    <name>alltact::ConvergencePlot</name>
    <message>
        <source>How the solution settles</source>
        <translation>解如何收敛</translation>
    </message>
    <message numerus="yes">
        <source>After %n round(s) %1 mm are left.</source>
        <translation>
            <numerusform>%n 轮后剩余 %1 mm。</numerusform>
        </translation>
    </message>
    <message>
        <source>The solution has not begun to settle yet</source>
        <translation>解尚未开始收敛</translation>
    </message>
    <message>
        <source>Left over</source>
        <translation>剩余</translation>
    </message>
    <message>
        <source>Left over (mm)</source>
        <translation>剩余 (mm)</translation>
    </message>
    <message>
        <source>Still moves</source>
        <translation>仍在变化</translation>
    </message>
    <message>
        <source>Unknowns still move by (mm)</source>
        <translation>未知量仍变化 (mm)</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>轮次</translation>
    </message>
</context>
<context>
    <name>alltact::CoverageView</name>
    <message>
        <source>bend away</source>
        <translation>向外弯</translation>
    </message>
    <message>
        <source>bend back</source>
        <translation>向回弯</translation>
    </message>
    <message>
        <source>sway up</source>
        <translation>向上摆</translation>
    </message>
    <message>
        <source>sway down</source>
        <translation>向下摆</translation>
    </message>
    <message>
        <source>twist right</source>
        <translation>向右扭</translation>
    </message>
    <message>
        <source>twist left</source>
        <translation>向左扭</translation>
    </message>
    <message>
        <source>Coverage of bending</source>
        <translation>弯曲覆盖情况</translation>
    </message>
    <message>
        <source>No pose has been seen yet.</source>
        <translation>还没有看到任何姿态。</translation>
    </message>
    <message>
        <source>Enough: all directions are reached.</source>
        <translation>足够：所有方向都已达到。</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>缺少：%1。</translation>
    </message>
</context>
<context>
    <name>alltact::EditMenu</name>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销：%1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做：%1(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
</context>
<context>
    <name>alltact::EventStrip</name>
    <message>
        <source>Contacts, problems and depth over time</source>
        <translation>接触、问题和深度随时间的变化</translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s)</source>
        <translation>
            <numerusform>%n 次接触</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with problems</source>
        <translation>
            <numerusform>%n 帧有问题</numerusform>
        </translation>
    </message>
    <message>
        <source>deepest %1 mm in frame %2</source>
        <translation>最深 %1 mm，在第 %2 帧</translation>
    </message>
    <message>
        <source>%1 of %2 frames measured</source>
        <translation>已测量 %1 / %2 帧</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>深度，mm</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>面积，mm²</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>力，N</translation>
    </message>
    <message>
        <source>Depth over time needs a calibration.</source>
        <translation>深度随时间的变化需要先标定。</translation>
    </message>
    <message>
        <source>The recording is being looked through.</source>
        <translation>正在查看录像。</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
</context>
<context>
    <name>alltact::ExperimentFigurePlot</name>
    <message>
        <source>Figure of an experiment</source>
        <translation>实验图表</translation>
    </message>
    <message>
        <source>Nothing was measured</source>
        <translation>没有测量结果</translation>
    </message>
</context>
<context>
    <name>alltact::ExportDialog</name>
    <message>
        <source>Export finger</source>
        <translation>导出手指</translation>
    </message>
    <message>
        <source>What finger %1 has learnt, for other programs.</source>
        <translation>手指 %1 学到的内容，供其他程序使用。</translation>
    </message>
    <message>
        <source>&amp;Folder for the files</source>
        <translation>存放文件的文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>存放文件的文件夹</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>The same as a command line</source>
        <translation>相同操作的命令行</translation>
    </message>
    <message>
        <source>Copy as command &amp;line</source>
        <translation>复制为命令行(&amp;L)</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>导出进度</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>导出(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;OpenCV: camera.opencv.yaml</source>
        <translation>OpenCV:camera.opencv.yaml(&amp;O)</translation>
    </message>
    <message>
        <source>Camera matrix and distortion, for cv::FileStorage.</source>
        <translation>相机矩阵和畸变，供 cv::FileStorage 读取。</translation>
    </message>
    <message>
        <source>&amp;ROS: camera_info.yaml and parameters.yaml</source>
        <translation>ROS：camera_info.yaml 和 parameters.yaml(&amp;R)</translation>
    </message>
    <message>
        <source>The camera as drivers and image_pipeline read it; face, markers and mapping as parameters of a ROS 2 node.</source>
        <translation>驱动程序和 image_pipeline 所读的相机；面、标记点和映射作为 ROS 2 节点的参数。</translation>
    </message>
    <message>
        <source>&amp;JSON: calibration.json</source>
        <translation>JSON:calibration.json(&amp;J)</translation>
    </message>
    <message>
        <source>All figures in one file, for programs of your own.</source>
        <translation>全部数值放在一个文件中，供自己的程序使用。</translation>
    </message>
    <message>
        <source>&amp;Whole finger: finger.zip</source>
        <translation>整个手指：finger.zip(&amp;W)</translation>
    </message>
    <message>
        <source>Every file of the finger, its untouched pictures too: to keep, to send, and to measure with in Python.</source>
        <translation>手指的所有文件，包括未触碰的图像：用于保存、发送，以及在 Python 中测量。</translation>
    </message>
    <message>
        <source>Nothing is chosen.</source>
        <translation>没有选择任何内容。</translation>
    </message>
    <message>
        <source>No folder is named.</source>
        <translation>未指定文件夹。</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>已写入：%1。</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) that this finger does not use are left out of the zip.</source>
        <translation>
            <numerusform>此手指未使用的 %n 段录像不放入 zip。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::FaceMapPlot</name>
    <message>
        <source>%1 over the face</source>
        <translation>面上的%1</translation>
    </message>
    <message>
        <source>Nothing is known of the face yet</source>
        <translation>对面还一无所知</translation>
    </message>
    <message>
        <source>Along the finger, from the base (mm)</source>
        <translation>沿手指，从根部 (mm)</translation>
    </message>
    <message>
        <source>Along the picture, from the left (mm)</source>
        <translation>沿图像，从左侧 (mm)</translation>
    </message>
    <message>
        <source>Across (mm)</source>
        <translation>横向 (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::FacePane</name>
    <message>
        <source>Face in 3D</source>
        <translation>接触面三维视图</translation>
    </message>
</context>
<context>
    <name>alltact::FingerCards</name>
    <message>
        <source>Not calibrated yet</source>
        <translation>尚未标定</translation>
    </message>
    <message>
        <source>Calibrated; how well is not kept</source>
        <translation>已标定；没有保存其质量</translation>
    </message>
    <message>
        <source>Calibrated %1</source>
        <translation>标定于 %1</translation>
    </message>
    <message>
        <source>Calibrated %1, checked %2</source>
        <translation>标定于 %1，检查于 %2</translation>
    </message>
    <message>
        <source>Due: record it bending</source>
        <translation>待办：录制它弯曲的过程</translation>
    </message>
    <message>
        <source>Due: calibrate it</source>
        <translation>待办：标定</translation>
    </message>
    <message>
        <source>Due: a check</source>
        <translation>待办：检查</translation>
    </message>
    <message>
        <source>Drifting: look at the last check</source>
        <translation>漂移：请查看最近一次检查</translation>
    </message>
    <message>
        <source>Due: calibrate it again</source>
        <translation>待办：重新标定</translation>
    </message>
    <message>
        <source>Nothing is due</source>
        <translation>没有待办事项</translation>
    </message>
    <message>
        <source>Open the finger %1</source>
        <translation>打开手指 %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>today</source>
        <translation>今天</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>昨天</translation>
    </message>
    <message numerus="yes">
        <source>%n days ago</source>
        <translation>
            <numerusform>%n 天前</numerusform>
        </translation>
    </message>
    <message>
        <source>calibrated %1</source>
        <translation>标定于 %1</translation>
    </message>
    <message>
        <source>checked %1, %2 off</source>
        <translation>检查于 %1，偏差 %2</translation>
    </message>
    <message>
        <source>Due: more presses</source>
        <translation>待办：增加按压</translation>
    </message>
    <message>
        <source>Due: read its verdict</source>
        <translation>待办：查看其结论</translation>
    </message>
    <message>
        <source>Due: restore its reference</source>
        <translation>待办：恢复参考</translation>
    </message>
    <message>
        <source>Due: record its reference again</source>
        <translation>待办：重新录制参考</translation>
    </message>
</context>
<context>
    <name>alltact::FingerListDialog</name>
    <message>
        <source>All fingers</source>
        <translation>全部手指</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>手指</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>手指</translation>
    </message>
    <message>
        <source>Worth</source>
        <translation>评价</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>误差，mm</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>待办</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Look into another folder…</source>
        <translation>查看其他文件夹(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Looking at the fingers&apos; folders…</source>
        <translation>正在查看手指的文件夹…</translation>
    </message>
    <message numerus="yes">
        <source>%n finger(s), </source>
        <translation>
            <numerusform>%n 个手指，</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>something is due with %n</source>
        <translation>
            <numerusform>%n 个有待办事项</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with fingers in it</source>
        <translation>存放手指的文件夹</translation>
    </message>
</context>
<context>
    <name>alltact::FingerMenu</name>
    <message>
        <source>&amp;Recent fingers</source>
        <translation>最近的手指(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Open finger…</source>
        <translation>打开手指(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;New finger…</source>
        <translation>新建手指(&amp;N)…</translation>
    </message>
    <message>
        <source>E&amp;xport finger…</source>
        <translation>导出手指(&amp;X)…</translation>
    </message>
    <message>
        <source>&amp;Close finger</source>
        <translation>关闭手指(&amp;C)</translation>
    </message>
    <message>
        <source>Open a finger&apos;s folder</source>
        <translation>打开手指文件夹</translation>
    </message>
    <message>
        <source>&amp;All fingers…</source>
        <translation>全部手指(&amp;A)…</translation>
    </message>
</context>
<context>
    <name>alltact::FingerPage</name>
    <message>
        <source>A flat, rigid sensor with a layer of %1 mm, %2 mm before the camera.</source>
        <translation>平面刚性传感器：层厚 %1 mm，距相机 %2 mm。</translation>
    </message>
    <message>
        <source>A Fin Ray finger whose face is %1 mm wide, with a layer of %2 mm and %3 dots on each side.</source>
        <translation>Fin Ray 手指：面宽 %1 mm，层厚 %2 mm，每侧 %3 个标记点。</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何尺寸</translation>
    </message>
    <message>
        <source>What it looks like untouched</source>
        <translation>未触碰时的样子</translation>
    </message>
    <message>
        <source>&amp;Make the finger&apos;s folder…</source>
        <translation>建立手指文件夹(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Open a finger…</source>
        <translation>打开手指(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Go to Record</source>
        <translation>转到录制(&amp;G)</translation>
    </message>
    <message>
        <source>Take the &amp;untouched picture now</source>
        <translation>立即拍摄未触碰的图像(&amp;U)</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>正在载入手指。</translation>
    </message>
    <message>
        <source>The finger needs a folder of its own: make one, or open one.</source>
        <translation>手指需要自己的文件夹：请新建或打开一个。</translation>
    </message>
    <message>
        <source>Its untouched picture is missing.</source>
        <translation>缺少未触碰的图像。</translation>
    </message>
    <message>
        <source>Its reference recording is missing: record it bending, untouched.</source>
        <translation>缺少参考录像：请录制它未被触碰时的弯曲过程。</translation>
    </message>
    <message>
        <source>Width and layer are measured with a caliper, dots are counted. All that is known of one finger is kept in one folder.</source>
        <translation>用卡尺测量宽度和层厚，并数出标记点。一个手指的全部信息都保存在一个文件夹里。</translation>
    </message>
    <message>
        <source>Its untouched picture is there.</source>
        <translation>未触碰的图像已有。</translation>
    </message>
    <message>
        <source>Its reference recording is installed.</source>
        <translation>参考录像已设置。</translation>
    </message>
    <message>
        <source>Every press is compared with one picture of the untouched face.</source>
        <translation>每次按压都与一张未触碰面的图像比较。</translation>
    </message>
    <message>
        <source>Every press is compared with a picture of the finger bent alike and not touched. Record it bending in all directions, then install the recording.</source>
        <translation>每次按压都与同样弯曲、未被触碰的手指图像比较。请录制它向各个方向弯曲的过程，然后设为参考。</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>手指</translation>
    </message>
    <message>
        <source>&amp;Width of the face</source>
        <translation>面的宽度(&amp;W)</translation>
    </message>
    <message>
        <source>Width of the face</source>
        <translation>面的宽度</translation>
    </message>
    <message>
        <source>&amp;Layer&apos;s thickness</source>
        <translation>层的厚度(&amp;L)</translation>
    </message>
    <message>
        <source>Thickness of the layer</source>
        <translation>层的厚度</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Change</source>
        <translation>更改(&amp;C)</translation>
    </message>
    <message>
        <source>A calibrated finger has to be calibrated again then.</source>
        <translation>已标定的手指之后需要重新标定。</translation>
    </message>
    <message>
        <source>change the finger&apos;s sizes</source>
        <translation>更改手指的尺寸</translation>
    </message>
</context>
<context>
    <name>alltact::FingerStudyRun</name>
    <message>
        <source>use other settings</source>
        <translation>使用其他设置</translation>
    </message>
</context>
<context>
    <name>alltact::FingerSummary</name>
    <message>
        <source>What is known of this finger</source>
        <translation>对此手指已知的信息</translation>
    </message>
    <message>
        <source>Go to Record</source>
        <translation>前往“录制”</translation>
    </message>
    <message>
        <source>Go to the check</source>
        <translation>前往检查</translation>
    </message>
    <message>
        <source>Go to Calibrate</source>
        <translation>前往“标定”</translation>
    </message>
</context>
<context>
    <name>alltact::ForceBox</name>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Re-&amp;zero</source>
        <translation>重新归零(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;As measured</source>
        <translation>按实测值(&amp;A)</translation>
    </message>
    <message>
        <source>Forces count from the model&apos;s own zero again.</source>
        <translation>力重新从模型自身的零点算起。</translation>
    </message>
    <message>
        <source>Force now</source>
        <translation>当前的力</translation>
    </message>
    <message>
        <source>From which zero forces count</source>
        <translation>力从哪个零点算起</translation>
    </message>
    <message>
        <source>Force over the last half minute</source>
        <translation>最近半分钟的力</translation>
    </message>
    <message>
        <source>The force model was trained with nothing like this picture.</source>
        <translation>力模型的训练数据中没有与此图像相似的情况。</translation>
    </message>
    <message>
        <source>A recording is shown as it was measured.</source>
        <translation>录像按实测值显示。</translation>
    </message>
    <message>
        <source>The mean of the last half second counts as no force from now on.</source>
        <translation>从现在起，最近半秒的平均值视为零力。</translation>
    </message>
    <message>
        <source>There is no reading in range that could count as zero.</source>
        <translation>没有可作为零点的范围内读数。</translation>
    </message>
    <message>
        <source>No force is told of this picture.</source>
        <translation>此图像没有给出力。</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>95 % lie within ±.</source>
        <translation>95 % 在 ± 范围以内。</translation>
    </message>
    <message>
        <source>Out of range: do not rely on it.</source>
        <translation>超出范围：请勿依赖此值。</translation>
    </message>
    <message>
        <source>Zero: the model&apos;s own.</source>
        <translation>零点：模型自身的零点。</translation>
    </message>
    <message>
        <source>Zero: the reading of %1, while something touched the finger.</source>
        <translation>零点：%1 的读数，当时有东西触碰手指。</translation>
    </message>
    <message>
        <source>Zero: the reading of %1.</source>
        <translation>零点：%1 的读数。</translation>
    </message>
</context>
<context>
    <name>alltact::ForcePlot</name>
    <message>
        <source>Time (s)</source>
        <translation>时间 (s)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>力 (N)</translation>
    </message>
</context>
<context>
    <name>alltact::ForceWords</name>
    <message>
        <source>The finger is being loaded.</source>
        <translation>正在加载手指。</translation>
    </message>
    <message>
        <source>Open a finger to see its forces.</source>
        <translation>请打开一个手指以查看其受力。</translation>
    </message>
    <message>
        <source>A finger without markers tells no forces.</source>
        <translation>没有标记点的手指不能给出力。</translation>
    </message>
    <message>
        <source>Forces are told once there is a reference recording.</source>
        <translation>有了参考录像后才会给出力。</translation>
    </message>
    <message>
        <source>No force is told of this picture.</source>
        <translation>此图像没有给出力。</translation>
    </message>
    <message>
        <source>This finger has no force model yet. A table of its markers beside a gauge&apos;s forces trains one:</source>
        <translation>此手指还没有力模型。可用其标记点与测力计的力并列的表训练一个：</translation>
    </message>
</context>
<context>
    <name>alltact::FrameWords</name>
    <message>
        <source>no depth: too dark</source>
        <translation>无深度：过暗</translation>
    </message>
    <message>
        <source>no depth: too bright</source>
        <translation>无深度：过亮</translation>
    </message>
    <message>
        <source>no depth: off the face</source>
        <translation>无深度：不在面上</translation>
    </message>
    <message>
        <source>u %1 px, v %2 px, grey %3</source>
        <translation>u %1 px，v %2 px，灰度 %3</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>深度 %1 mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>深度，mm</translation>
    </message>
</context>
<context>
    <name>alltact::GripperDialog</name>
    <message>
        <source>%1 in the gripper</source>
        <translation>夹爪中的 %1</translation>
    </message>
    <message>
        <source>Where the camera of %1 sits in the gripper&apos;s frame: its place, and how it is turned about the gripper&apos;s axes, first x, then y, then z. A camera that is not turned looks along the gripper&apos;s z, with x along its picture and y across it.</source>
        <translation>%1 的相机在夹爪坐标系中的安装位置：其位置，以及绕夹爪各轴的转角，依次为 x、y、z。未转动的相机沿夹爪的 z 方向观察，x 沿图像长度方向，y 沿图像宽度方向。</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>位置(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Turned about</source>
        <translation>转角(&amp;T)</translation>
    </message>
    <message>
        <source>Place, x</source>
        <translation>位置，x</translation>
    </message>
    <message>
        <source>Place, y</source>
        <translation>位置，y</translation>
    </message>
    <message>
        <source>Place, z</source>
        <translation>位置，z</translation>
    </message>
    <message>
        <source>Turned about x</source>
        <translation>绕 x 的转角</translation>
    </message>
    <message>
        <source>Turned about y</source>
        <translation>绕 y 的转角</translation>
    </message>
    <message>
        <source>Turned about z</source>
        <translation>绕 z 的转角</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>设置(&amp;S)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;Not known</source>
        <translation>未知(&amp;N)</translation>
    </message>
    <message>
        <source>Takes the place out of the finger&apos;s file.</source>
        <translation>从手指文件中删除该位置。</translation>
    </message>
</context>
<context>
    <name>alltact::GuideWords</name>
    <message>
        <source>Press here, %1 mm deep</source>
        <translation>在此按压，深 %1 mm</translation>
    </message>
    <message>
        <source>Enough presses: another would hardly help.</source>
        <translation>按压已足够：再多也几乎没有帮助。</translation>
    </message>
    <message>
        <source>now %1 mm: deeper</source>
        <translation>现在 %1 mm：再深一些</translation>
    </message>
    <message>
        <source>now %1 mm: enough, hold still</source>
        <translation>现在 %1 mm：够了，保持不动</translation>
    </message>
    <message>
        <source>now %1 mm: too deep</source>
        <translation>现在 %1 mm：太深</translation>
    </message>
    <message>
        <source>now %1 mm, %2 mm away from there</source>
        <translation>现在 %1 mm，距该处 %2 mm</translation>
    </message>
    <message>
        <source>It is taken as soon as ball and finger are held still.</source>
        <translation>球和手指一保持不动，就会记录。</translation>
    </message>
    <message>
        <source>Not taken: ball and finger were not held still. Hold them still for half a second.</source>
        <translation>未记录：球和手指没有保持不动。请保持半秒钟不动。</translation>
    </message>
</context>
<context>
    <name>alltact::HeaderBar</name>
    <message>
        <source>Finger:</source>
        <translation>手指：</translation>
    </message>
    <message>
        <source>Source:</source>
        <translation>来源：</translation>
    </message>
    <message>
        <source>Finger: %1</source>
        <translation>手指：%1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>来源：%1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>finger</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 (loading)</source>
        <translation>%1（正在加载）</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1（仿真）</translation>
    </message>
</context>
<context>
    <name>alltact::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Help on this place</source>
        <translation>本页帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;About AllTact Studio</source>
        <translation>关于 AllTact Studio(&amp;A)</translation>
    </message>
    <message>
        <source>About AllTact Studio</source>
        <translation>关于 AllTact Studio</translation>
    </message>
    <message>
        <source>## AllTact Studio %1

Turns a clear silicone finger with a camera inside into a measuring instrument.

Its own source is under the BSD-3-Clause licence; with the libraries it uses, the program as a whole is under the GPL, version 3.</source>
        <translation>## AllTact Studio %1

把内置相机的透明硅胶手指变成测量仪器。

自有源代码采用 BSD-3-Clause 许可；连同所用的库，整个程序采用 GPL 第 3 版许可。</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>术语表(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Quick guide to print…</source>
        <translation>可打印的快速指南(&amp;Q)…</translation>
    </message>
    <message>
        <source>Save the quick guide</source>
        <translation>保存快速指南</translation>
    </message>
    <message>
        <source>Pages to print (*.pdf)</source>
        <translation>可打印的页面 (*.pdf)</translation>
    </message>
</context>
<context>
    <name>alltact::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation>术语表</translation>
    </message>
    <message>
        <source>Effects of scenes</source>
        <translation>场景的效果</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
</context>
<context>
    <name>alltact::HistogramPlot</name>
    <message>
        <source>Spread of the errors</source>
        <translation>误差分布</translation>
    </message>
    <message>
        <source>95 % of the errors are below %1 mm.</source>
        <translation>95 % 的误差小于 %1 mm。</translation>
    </message>
    <message>
        <source>No errors to show yet</source>
        <translation>尚无误差可显示</translation>
    </message>
    <message>
        <source>Share of all blocks (%)</source>
        <translation>占全部小块的比例 (%)</translation>
    </message>
    <message>
        <source>95 % within
± %1 mm</source>
        <translation>95 % 在
± %1 mm 以内</translation>
    </message>
</context>
<context>
    <name>alltact::HistoryPlot</name>
    <message>
        <source>Checks over time</source>
        <translation>历次检查</translation>
    </message>
    <message>
        <source>Not checked yet since the calibration</source>
        <translation>标定后尚未检查</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>drifting</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>recalibrate</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>Time (UTC)</source>
        <translation>时间 (UTC)</translation>
    </message>
    <message>
        <source>Depth error (mm)</source>
        <translation>深度误差 (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::ImageView</name>
    <message>
        <source>Picture</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>The camera&apos;s picture. The wheel or + and - zoom, 0 shows all of it, 1 its own size. Drag or use the arrow keys to move it; Shift and the arrow keys move the probe.</source>
        <translation>相机图像。滚轮或 + 和 - 缩放，0 显示全部，1 为原始大小。拖动或用方向键移动；Shift 加方向键移动探针。</translation>
    </message>
</context>
<context>
    <name>alltact::InspectPane</name>
    <message>
        <source>Difference, mm</source>
        <translation>差值，mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>深度，mm</translation>
    </message>
    <message>
        <source>There is nothing to compare with in this frame.</source>
        <translation>此帧中没有可比较的内容。</translation>
    </message>
    <message>
        <source>It is being measured a second time, to be compared.</source>
        <translation>正在再测量一次，以便比较。</translation>
    </message>
</context>
<context>
    <name>alltact::InspectPage</name>
    <message>
        <source>&amp;Live finger</source>
        <translation>实时手指(&amp;L)</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>当前显示内容</translation>
    </message>
    <message>
        <source>Deepest contact</source>
        <translation>最深接触</translation>
    </message>
    <message>
        <source>What was saved</source>
        <translation>已保存的内容</translation>
    </message>
    <message>
        <source>put point B</source>
        <translation>放置 B 点</translation>
    </message>
    <message>
        <source>put point A</source>
        <translation>放置 A 点</translation>
    </message>
    <message>
        <source>Shown: the live finger</source>
        <translation>显示：实时手指</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>显示：%1</translation>
    </message>
    <message>
        <source>The finger is not calibrated yet, so brightness cannot be told as depth.</source>
        <translation>手指尚未标定，无法由亮度得到深度。</translation>
    </message>
    <message>
        <source>The face was not found in this picture.</source>
        <translation>在此图片中未找到接触面。</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>正在加载手指。</translation>
    </message>
    <message>
        <source>Nothing can be shown; above stands why.</source>
        <translation>无法显示；原因见上方。</translation>
    </message>
    <message>
        <source>The recording is being opened.</source>
        <translation>正在打开录像。</translation>
    </message>
    <message>
        <source>No source is open. Choose one above, or open a recording.</source>
        <translation>没有打开的图像源。请在上方选择，或打开一段录像。</translation>
    </message>
    <message>
        <source>No finger is open. Open the one that is seen, above.</source>
        <translation>没有打开的手指。请在上方打开画面中的手指。</translation>
    </message>
    <message>
        <source>Waiting for the first picture.</source>
        <translation>等待第一张图片。</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>打开视频</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.avi *.mp4)</source>
        <translation>视频 (*.mkv *.avi *.mp4)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
        <translation>打开图片文件夹</translation>
    </message>
    <message>
        <source>Save what is shown</source>
        <translation>保存当前显示内容</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>show all again</source>
        <translation>重新显示全部</translation>
    </message>
    <message>
        <source>turn the 3D view</source>
        <translation>转动三维视图</translation>
    </message>
    <message>
        <source>inspect %1</source>
        <translation>检视 %1</translation>
    </message>
    <message>
        <source>go on with what was inspected</source>
        <translation>继续上次检视的内容</translation>
    </message>
    <message>
        <source>inspect the live finger</source>
        <translation>检视实时手指</translation>
    </message>
    <message>
        <source>1: %1, 2: %2, in the gripper&apos;s frame X, Y, Z</source>
        <translation>1：%1，2：%2，在夹爪坐标系 X、Y、Z 中</translation>
    </message>
    <message>
        <source>place %1 in the gripper</source>
        <translation>设置 %1 在夹爪中的位置</translation>
    </message>
    <message>
        <source>Where the camera of %1 sits in the gripper is not known, so the two fingers are shown each in its own camera&apos;s frame.</source>
        <translation>尚不知道 %1 的相机在夹爪中的位置，因此两个手指分别显示在各自相机的坐标系中。</translation>
    </message>
    <message>
        <source>Tell its place and how it is turned.</source>
        <translation>请输入其位置和转角。</translation>
    </message>
    <message>
        <source>Place of &amp;2…</source>
        <translation>&amp;2 的位置…</translation>
    </message>
    <message>
        <source>Place of &amp;1…</source>
        <translation>&amp;1 的位置…</translation>
    </message>
    <message>
        <source>show a second finger</source>
        <translation>显示第二个手指</translation>
    </message>
    <message>
        <source>close the second finger</source>
        <translation>关闭第二个手指</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>检视</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>检视(&amp;I)</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>What touches the finger</source>
        <translation>触碰手指的东西</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>还没有图像。</translation>
    </message>
    <message>
        <source>Vide&amp;o…</source>
        <translation>视频(&amp;O)…</translation>
    </message>
    <message>
        <source>Folder of p&amp;ictures…</source>
        <translation>图片文件夹(&amp;I)…</translation>
    </message>
    <message>
        <source>Under the pointer</source>
        <translation>指针下方</translation>
    </message>
    <message>
        <source>Compared with: %1</source>
        <translation>比较对象：%1</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>当前显示</translation>
    </message>
    <message>
        <source>Shown less: %1</source>
        <translation>当前显示减去：%1</translation>
    </message>
    <message>
        <source>Not calibrated yet: the shape of the whole finger, without depth</source>
        <translation>尚未标定：显示整个手指的形状，没有深度</translation>
    </message>
    <message>
        <source>Point at the face: what lies there is told here.</source>
        <translation>把指针移到面上，这里会显示该处的数值。</translation>
    </message>
</context>
<context>
    <name>alltact::InspectSide</name>
    <message>
        <source>Cross-section</source>
        <translation>剖面</translation>
    </message>
</context>
<context>
    <name>alltact::JoinedWords</name>
    <message>
        <source>, </source>
        <comment>between things of one kind</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between parts of a sentence</comment>
        <translation>，</translation>
    </message>
    <message>
        <source>; </source>
        <comment>between clauses</comment>
        <translation>；</translation>
    </message>
    <message>
        <source>: </source>
        <comment>after what names the next</comment>
        <translation>：</translation>
    </message>
</context>
<context>
    <name>alltact::LampPanel</name>
    <message>
        <source>Dimmer</source>
        <translation>调光器</translation>
    </message>
    <message>
        <source>The lamp&apos;s dimmer</source>
        <translation>灯的调光器</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Look for dimmers</source>
        <translation>查找调光器</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>The dimmer&apos;s output</source>
        <translation>调光器的输出</translation>
    </message>
    <message>
        <source>MCP2221A, pin GP2</source>
        <translation>MCP2221A，引脚 GP2</translation>
    </message>
    <message>
        <source>MCP2221A, pin GP3</source>
        <translation>MCP2221A，引脚 GP3</translation>
    </message>
    <message>
        <source>A report, described</source>
        <translation>自行描述的报告</translation>
    </message>
    <message>
        <source>Report that sets the brightness</source>
        <translation>设置亮度的报告</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The lamp&apos;s brightness</source>
        <translation>灯的亮度</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Set to %1 %. Every picture tells it.</source>
        <translation>已设为 %1 %。每张图像都会注明。</translation>
    </message>
    <message>
        <source>The dimmer is being told.</source>
        <translation>正在设置调光器。</translation>
    </message>
    <message>
        <source>Choose the device that dims the finger&apos;s lamp, where there is one.</source>
        <translation>如有给手指的灯调光的设备，请选择它。</translation>
    </message>
</context>
<context>
    <name>alltact::NumberText</name>
    <message>
        <source>under %1</source>
        <comment>of a standard deviation</comment>
        <translation>小于 %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <comment>of a standard deviation</comment>
        <translation>未知</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
</context>
<context>
    <name>alltact::LimitWords</name>
    <message>
        <source>at the layer&apos;s limit</source>
        <translation>达到涂层极限</translation>
    </message>
    <message>
        <source>beyond what was calibrated</source>
        <translation>超出标定范围</translation>
    </message>
    <message>
        <source>doubtful light</source>
        <translation>光照可疑</translation>
    </message>
    <message>
        <source>steep: its place matters</source>
        <translation>陡坡：位置影响大</translation>
    </message>
</context>
<context>
    <name>alltact::LensForm</name>
    <message>
        <source>&amp;Board</source>
        <translation>标定板(&amp;B)</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>标定板</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco 板</translation>
    </message>
    <message>
        <source>Grid of dots</source>
        <translation>圆点阵</translation>
    </message>
    <message>
        <source>&amp;Inner corners, or dots</source>
        <translation>内角点或圆点(&amp;I)</translation>
    </message>
    <message>
        <source>Inner corners in a row</source>
        <translation>每行内角点数</translation>
    </message>
    <message>
        <source>Inner corners in a column</source>
        <translation>每列内角点数</translation>
    </message>
    <message>
        <source>by</source>
        <translation>×</translation>
    </message>
    <message>
        <source>&amp;Side of a square</source>
        <translation>方格边长(&amp;S)</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>方格边长</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>usual (Brown)</source>
        <translation>普通 (Brown)</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>鱼眼</translation>
    </message>
    <message>
        <source>Finger&apos;s distance</source>
        <translation>手指的距离</translation>
    </message>
    <message>
        <source>Distance from the lens to the finger&apos;s middle</source>
        <translation>镜头到手指中部的距离</translation>
    </message>
    <message>
        <source>The finger lies behind a window</source>
        <translation>手指在窗口后面</translation>
    </message>
    <message>
        <source>Tick it where the finger is seen through a plate into silicone and the board was seen in air</source>
        <translation>如果透过平板看硅胶中的手指，而标定板是在空气中看的，请勾选</translation>
    </message>
    <message>
        <source>Air before it</source>
        <translation>前面的空气</translation>
    </message>
    <message>
        <source>Air between lens and window</source>
        <translation>镜头与窗口之间的空气</translation>
    </message>
    <message>
        <source>Its thickness</source>
        <translation>其厚度</translation>
    </message>
    <message>
        <source>Thickness of the window</source>
        <translation>窗口的厚度</translation>
    </message>
    <message>
        <source>Its index</source>
        <translation>其折射率</translation>
    </message>
    <message>
        <source>Index of refraction of the window</source>
        <translation>窗口的折射率</translation>
    </message>
    <message>
        <source>Index behind it</source>
        <translation>后面的折射率</translation>
    </message>
    <message>
        <source>Index of refraction behind the window</source>
        <translation>窗口后面的折射率</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>alltact::LensPage</name>
    <message>
        <source>a lens without distortion</source>
        <translation>无畸变的镜头</translation>
    </message>
    <message>
        <source>a lens with distortion (Brown)</source>
        <translation>有畸变的镜头 (Brown)</translation>
    </message>
    <message>
        <source>a fisheye lens</source>
        <translation>鱼眼镜头</translation>
    </message>
    <message>
        <source>a lens with parallel rays</source>
        <translation>平行光线镜头</translation>
    </message>
    <message>
        <source>%1, %2 × %3 px</source>
        <translation>%1，%2 × %3 px</translation>
    </message>
    <message>
        <source>Its calibration: %1.</source>
        <translation>其标定：%1。</translation>
    </message>
    <message>
        <source>From a camera file</source>
        <translation>来自相机文件</translation>
    </message>
    <message>
        <source>Or measured with pictures of a board</source>
        <translation>或者用标定板图片测量</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>相机文件</translation>
    </message>
    <message>
        <source>camera.yaml, as the lens calibration writes it</source>
        <translation>镜头标定写出的 camera.yaml</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>选择(&amp;C)…</translation>
    </message>
    <message>
        <source>Choose a camera file</source>
        <translation>选择相机文件</translation>
    </message>
    <message>
        <source>&amp;Use the simulated camera&apos;s lens</source>
        <translation>使用模拟相机的镜头(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Pictures</source>
        <translation>图片(&amp;P)</translation>
    </message>
    <message>
        <source>Folder of board pictures, or a recording</source>
        <translation>标定板图片的文件夹，或一段录像</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the folder of board pictures</source>
        <translation>选择标定板图片的文件夹</translation>
    </message>
    <message>
        <source>&amp;Measure the lens</source>
        <translation>测量镜头(&amp;M)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop measuring the lens</source>
        <translation>停止测量镜头</translation>
    </message>
    <message>
        <source>Progress of the lens calibration</source>
        <translation>镜头标定进度</translation>
    </message>
    <message>
        <source>Outcome of the lens calibration</source>
        <translation>镜头标定的结果</translation>
    </message>
    <message>
        <source>The lens has to be known first: choose a camera file, or measure one.</source>
        <translation>必须先知道镜头：请选择相机文件或进行测量。</translation>
    </message>
    <message>
        <source>This finger&apos;s camera has %1</source>
        <translation>此手指的相机：%1</translation>
    </message>
    <message>
        <source>The camera has %1</source>
        <translation>相机：%1</translation>
    </message>
    <message>
        <source>A finger measures through its camera&apos;s lens, so the lens comes first. It is measured once for each camera, with ten to twenty pictures of a flat board from all sides.</source>
        <translation>手指通过相机镜头测量，所以先要知道镜头。每台相机只需测量一次：从各个方向拍摄十到二十张平面标定板的图片。</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml)</source>
        <translation>相机 (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Folder of board pictures</source>
        <translation>标定板图片的文件夹</translation>
    </message>
    <message>
        <source>No folder of pictures is named.</source>
        <translation>没有指定图片文件夹。</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>已写入 %1。</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>With a board before the camera</source>
        <translation>把标定板放在相机前</translation>
    </message>
    <message>
        <source>&amp;Take this board (Space)</source>
        <translation>采集这块板(&amp;T)（空格键）</translation>
    </message>
    <message>
        <source>By &amp;itself where it is new and still</source>
        <translation>位置新且静止时自动采集(&amp;I)</translation>
    </message>
    <message>
        <source>Takes the board whenever it is held still in a place, or tilted in a way, that was not taken yet</source>
        <translation>每当标定板在尚未采集的位置或倾角上保持不动时就采集</translation>
    </message>
    <message>
        <source>How to hold the board</source>
        <translation>如何拿标定板</translation>
    </message>
    <message>
        <source>Views of the board, with their errors</source>
        <translation>标定板的视图及其误差</translation>
    </message>
    <message>
        <source>Leave the chosen view out</source>
        <translation>排除所选视图</translation>
    </message>
    <message>
        <source>Blue: straight lines of the world, as this lens shows them.</source>
        <translation>蓝色：此镜头所呈现的现实中的直线。</translation>
    </message>
    <message>
        <source>Still better with: %1.</source>
        <translation>加上这些会更好：%1。</translation>
    </message>
    <message>
        <source>%1: error %2 px, tilted by %3°</source>
        <translation>%1：误差 %2 px，倾斜 %3°</translation>
    </message>
    <message>
        <source>%1: not used, %2</source>
        <translation>%1：未使用，%2</translation>
    </message>
    <message>
        <source>Board %1</source>
        <translation>标定板 %1</translation>
    </message>
    <message>
        <source>Open the camera as source, and boards can be taken live.</source>
        <translation>把相机打开为来源，即可实时采集标定板。</translation>
    </message>
    <message>
        <source>Looking for the board.</source>
        <translation>正在寻找标定板。</translation>
    </message>
    <message>
        <source>The board is blurred: hold it still, or further away.</source>
        <translation>标定板模糊：请拿稳，或拿远一些。</translation>
    </message>
    <message>
        <source>This place is taken: move the board, or tilt it.</source>
        <translation>此位置已采集：请移动或倾斜标定板。</translation>
    </message>
    <message>
        <source>Hold it still.</source>
        <translation>请保持不动。</translation>
    </message>
    <message>
        <source>Good: take it.</source>
        <translation>很好：请采集。</translation>
    </message>
    <message>
        <source>Still missing: %1.</source>
        <translation>还缺少：%1。</translation>
    </message>
    <message>
        <source>%1 mm a pixel</source>
        <translation>每像素 %1 mm</translation>
    </message>
    <message>
        <source>focal length %1 px</source>
        <translation>焦距 %1 px</translation>
    </message>
    <message>
        <source>behind a window</source>
        <translation>隔着窗口</translation>
    </message>
</context>
<context>
    <name>alltact::LivePairBox</name>
    <message>
        <source>Second finger</source>
        <translation>第二个手指</translation>
    </message>
    <message>
        <source>&amp;Second finger…</source>
        <translation>第二个手指(&amp;S)…</translation>
    </message>
    <message>
        <source>Close it</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Mo&amp;tor at</source>
        <translation>电机位于(&amp;T)</translation>
    </message>
    <message>
        <source> turns</source>
        <translation> 圈</translation>
    </message>
    <message>
        <source>Motor position in turns</source>
        <translation>电机位置，单位为圈</translation>
    </message>
    <message>
        <source>Where the gripper&apos;s motor stands: the figures hold for this position.</source>
        <translation>夹爪电机所处的位置：数值对应于此位置。</translation>
    </message>
    <message>
        <source>Gap and width</source>
        <translation>间隙和宽度</translation>
    </message>
    <message>
        <source>Whether both pictures are of one moment</source>
        <translation>两幅图像是否属于同一时刻</translation>
    </message>
    <message>
        <source>Waiting for the second picture.</source>
        <translation>正在等待第二幅图像。</translation>
    </message>
    <message>
        <source>Without times of capture: the newest of both.</source>
        <translation>没有拍摄时间：显示两者各自最新的图像。</translation>
    </message>
    <message>
        <source>In time: 2 was taken %1 ms after 1.</source>
        <translation>同步：2 比 1 晚 %1 ms 拍摄。</translation>
    </message>
    <message>
        <source>Not in time: 2 was taken %1 ms after 1, more than half a frame.</source>
        <translation>不同步：2 比 1 晚 %1 ms 拍摄，超过半帧。</translation>
    </message>
    <message>
        <source>With a gripper.yaml, the gap between the faces and the width of what is held are told here.</source>
        <translation>有 gripper.yaml 时，此处给出两个面之间的间隙和所夹物体的宽度。</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>正在测量…</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Held width</source>
        <translation>夹持宽度</translation>
    </message>
    <message>
        <source>No gap is told: both faces need depth.</source>
        <translation>没有给出间隙：两个面都需要深度。</translation>
    </message>
    <message>
        <source>Nothing is held by both.</source>
        <translation>两个手指没有共同夹住任何东西。</translation>
    </message>
</context>
<context>
    <name>alltact::LivePage</name>
    <message>
        <source>show %1</source>
        <translation>显示%1</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>隐藏%1</translation>
    </message>
    <message>
        <source>change the depth colours</source>
        <translation>更改深度颜色</translation>
    </message>
    <message>
        <source>Over the picture</source>
        <translation>叠加显示</translation>
    </message>
    <message>
        <source>&amp;Edges of the face</source>
        <translation>面的边缘(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Markers with numbers</source>
        <translation>带编号的标记点(&amp;M)</translation>
    </message>
    <message>
        <source>Direction of &amp;contact</source>
        <translation>接触方向(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Depth in colours</source>
        <translation>彩色深度(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Too dark or too bright</source>
        <translation>过暗或过亮(&amp;T)</translation>
    </message>
    <message>
        <source>A ring: the marker is seen. A dashed diamond: its place is an estimate.</source>
        <translation>圆圈：看得见标记点。虚线菱形：位置为估计值。</translation>
    </message>
    <message>
        <source>Stripes falling to the right: too bright to measure. Stripes falling to the left: too dark.</source>
        <translation>向右下的条纹：过亮，无法测量。向左下的条纹：过暗。</translation>
    </message>
    <message>
        <source>Colours &amp;end at</source>
        <translation>颜色上限(&amp;E)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Depth at which the colours end</source>
        <translation>颜色上限对应的深度</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Time of a frame</source>
        <translation>每帧用时</translation>
    </message>
    <message>
        <source>change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>lock brightness</source>
        <translation>锁定亮度</translation>
    </message>
    <message>
        <source>unlock brightness</source>
        <translation>解锁亮度</translation>
    </message>
    <message>
        <source>No picture yet.</source>
        <translation>还没有图像。</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Preparation</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边缘</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>实时(&amp;L)</translation>
    </message>
    <message>
        <source>What touches the finger</source>
        <translation>触碰手指的东西</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>change the motor&apos;s position</source>
        <translation>更改电机位置</translation>
    </message>
    <message>
        <source>watch a second finger</source>
        <translation>观察第二个手指</translation>
    </message>
    <message>
        <source>close the second finger</source>
        <translation>关闭第二个手指</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>灯</translation>
    </message>
    <message>
        <source>dim the lamp</source>
        <translation>给灯调光</translation>
    </message>
    <message>
        <source>choose the lamp&apos;s dimmer</source>
        <translation>选择灯的调光器</translation>
    </message>
</context>
<context>
    <name>alltact::MainWindow</name>
    <message>
        <source>AllTact Studio</source>
        <translation>AllTact Studio</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>S&amp;ettings…</source>
        <translation>设置(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全屏(&amp;F)</translation>
    </message>
    <message>
        <source>go on with the last session</source>
        <translation>继续上次的会话</translation>
    </message>
    <message>
        <source>finger %1</source>
        <translation>手指 %1</translation>
    </message>
    <message>
        <source>source %1</source>
        <translation>来源 %1</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>录像 %1</translation>
    </message>
    <message>
        <source>A recording is under way</source>
        <translation>正在录制</translation>
    </message>
    <message>
        <source>A recording is under way. Quitting ends it; what was recorded until then is kept.</source>
        <translation>正在录制。退出会结束录制，此前录下的内容会保留。</translation>
    </message>
    <message>
        <source>&amp;End it and quit</source>
        <translation>结束并退出(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Go on recording</source>
        <translation>继续录制(&amp;G)</translation>
    </message>
</context>
<context>
    <name>alltact::MappingPage</name>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Keeps the best solution so far</source>
        <translation>保留目前最好的解</translation>
    </message>
    <message>
        <source>What has been done</source>
        <translation>已完成的工作</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>标定进度</translation>
    </message>
    <message>
        <source>Depth over brightness difference</source>
        <translation>深度与亮度差的关系</translation>
    </message>
    <message>
        <source>Error of every press, worst first</source>
        <translation>各次按压的误差，最大的在前</translation>
    </message>
    <message>
        <source>The calibration is being made.</source>
        <translation>正在标定。</translation>
    </message>
    <message>
        <source>Calibrate first.</source>
        <translation>请先标定。</translation>
    </message>
    <message>
        <source>&amp;Calibrate now</source>
        <translation>立即标定(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Calibrate again</source>
        <translation>重新标定(&amp;C)</translation>
    </message>
    <message numerus="yes">
        <source>(about %n second(s) left)</source>
        <translation>
            <numerusform>（约剩 %n 秒）</numerusform>
        </translation>
    </message>
    <message>
        <source>This finger is calibrated. Calibrating again shows the figures.</source>
        <translation>此手指已标定。重新标定可显示图表。</translation>
    </message>
    <message>
        <source>With one press or more, what every pixel&apos;s darkening means in mm is learnt from the shape of the ball.</source>
        <translation>有一次或多次按压后，由球的形状学得每个像素变暗意味着多少毫米。</translation>
    </message>
    <message>
        <source>What every pixel&apos;s darkening means in mm is learnt from the shape of the ball, with all presses together. Each press is left out once to see how well the others foretell it.</source>
        <translation>每个像素变暗意味着多少毫米，由球的形状和全部按压一起学得。每次按压都会被留出一次，看其余的能预测得多好。</translation>
    </message>
    <message>
        <source>Mapping: %1.</source>
        <translation>映射：%1。</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>映射</translation>
    </message>
    <message>
        <source>The presses are read again to show what each pixel says.</source>
        <translation>正在重新读取按压，以显示每个像素的结果。</translation>
    </message>
    <message>
        <source>What these presses would come to; not in use yet.</source>
        <translation>这些按压将得出的结果；尚未启用。</translation>
    </message>
    <message>
        <source>S&amp;how this press</source>
        <translation>显示这次按压(&amp;H)</translation>
    </message>
    <message>
        <source>Click a bar or a circle: which points are this press&apos;s, and where.</source>
        <translation>点击条形或圆圈，可看到哪些点属于该次按压以及它的位置。</translation>
    </message>
    <message>
        <source>%1 is taken out: the next calibration goes without it.</source>
        <translation>%1 已取出：下次标定不使用它。</translation>
    </message>
    <message>
        <source>%1: its points are marked +, its circle is bold.</source>
        <translation>%1：其点标为 +，其圆圈加粗。</translation>
    </message>
</context>
<context>
    <name>alltact::MappingPlot</name>
    <message>
        <source>Mapping from brightness to depth</source>
        <translation>亮度到深度的映射</translation>
    </message>
    <message>
        <source>No mapping yet: calibrate with ball presses</source>
        <translation>尚无映射：请用钢球按压标定</translation>
    </message>
    <message>
        <source>± 2 standard deviations</source>
        <translation>± 2 倍标准差</translation>
    </message>
    <message>
        <source>nearer the rim</source>
        <translation>靠近边缘</translation>
    </message>
    <message>
        <source>inner part of a contact</source>
        <translation>接触的内部</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>映射</translation>
    </message>
    <message>
        <source>Brightness difference x (no unit)</source>
        <translation>亮度差 x（无单位）</translation>
    </message>
    <message>
        <source>Brightness difference x (share of the untouched brightness)</source>
        <translation>亮度差 x（占未触碰亮度的比例）</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>深度 (mm)</translation>
    </message>
    <message>
        <source>Press depth (mm)</source>
        <translation>按压深度 (mm)</translation>
    </message>
    <message>
        <source>end of the calibrated range</source>
        <translation>标定范围的终点</translation>
    </message>
</context>
<context>
    <name>alltact::MoreDataBox</name>
    <message>
        <source>What more would bring</source>
        <translation>再多会带来什么</translation>
    </message>
    <message>
        <source>Progress of working it out</source>
        <translation>计算进度</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>停止(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Work it out</source>
        <translation>计算(&amp;W)</translation>
    </message>
    <message>
        <source>One more press, more pictures of each, one more minute: told by balls painted into this finger&apos;s own pictures, which calibrate it anew.</source>
        <translation>多一次按压、每次多几张图像、多一分钟：由画入此手指自己图像中的球得出，并用它们重新标定。</translation>
    </message>
    <message>
        <source>Nothing that was tried brings more.</source>
        <translation>所尝试的都不会带来更多。</translation>
    </message>
</context>
<context>
    <name>alltact::NewFingerDialog</name>
    <message>
        <source>New finger</source>
        <translation>新建手指</translation>
    </message>
    <message>
        <source>&amp;Folder to make</source>
        <translation>要新建的文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Camera file</source>
        <translation>相机文件(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>种类(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Width of the face</source>
        <translation>面的宽度(&amp;W)</translation>
    </message>
    <message>
        <source>Thickness of the &amp;layer</source>
        <translation>层的厚度(&amp;L)</translation>
    </message>
    <message>
        <source>Distance of the &amp;plane</source>
        <translation>平面的距离(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Dots on each side</source>
        <translation>每侧标记点数(&amp;D)</translation>
    </message>
    <message>
        <source>Dots &amp;are</source>
        <translation>标记点(&amp;A)</translation>
    </message>
    <message>
        <source>Fin Ray finger: its shape is read from the face&apos;s edges</source>
        <translation>鳍条手指：形状由面的边缘得出</translation>
    </message>
    <message>
        <source>Flat, rigid sensor</source>
        <translation>平面刚性传感器</translation>
    </message>
    <message>
        <source>found out by the reference recording</source>
        <translation>由参考录像判断</translation>
    </message>
    <message>
        <source>brighter than around them</source>
        <translation>比周围亮</translation>
    </message>
    <message>
        <source>darker than around them</source>
        <translation>比周围暗</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>Choose the camera file</source>
        <translation>选择相机文件</translation>
    </message>
    <message>
        <source>&amp;Make the finger</source>
        <translation>新建手指(&amp;M)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Folder to make</source>
        <translation>要新建的文件夹</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>相机文件</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml)</source>
        <translation>相机 (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>No folder is named.</source>
        <translation>未指定文件夹。</translation>
    </message>
    <message>
        <source>No camera file is named.</source>
        <translation>未指定相机文件。</translation>
    </message>
    <message>
        <source>Measure width and layer with a caliper, and count the dots. The camera file comes from the lens calibration, the first step of Calibrate.</source>
        <translation>用卡尺测量宽度和层厚，并数出标记点。相机文件来自镜头标定，即“标定”的第一步。</translation>
    </message>
    <message>
        <source>The first step of Calibrate makes one.</source>
        <translation>“标定”的第一步会生成它。</translation>
    </message>
</context>
<context>
    <name>alltact::OutlineEditor</name>
    <message>
        <source>Picture with the ball&apos;s outline</source>
        <translation>带球轮廓的图像</translation>
    </message>
    <message>
        <source>Drag the outline&apos;s centre or rim onto the ball. Arrow keys move it by a tenth of a pixel, Page Up and Page Down change its size, with Shift by a whole pixel. Ctrl and the arrow keys move the picture; the wheel zooms, over the rim it changes the size.</source>
        <translation>把轮廓的中心或边缘拖到球上。方向键移动十分之一像素，Page Up 和 Page Down 改变大小，加 Shift 为一个像素。Ctrl 加方向键移动画面；滚轮缩放，在边缘上则改变大小。</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px; ball at x %4, y %5, z %6 mm</source>
        <translation>中心 u %1 px，v %2 px，半径 %3 px；球在 x %4、y %5、z %6 mm</translation>
    </message>
</context>
<context>
    <name>alltact::PairBox</name>
    <message>
        <source>Second finger</source>
        <translation>第二个手指</translation>
    </message>
    <message>
        <source>Second fin&amp;ger…</source>
        <translation>第二个手指(&amp;G)…</translation>
    </message>
    <message>
        <source>Close it</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Place of 1…</source>
        <translation>1 的位置…</translation>
    </message>
    <message>
        <source>Place of 2…</source>
        <translation>2 的位置…</translation>
    </message>
    <message>
        <source>Place of the first finger in the gripper</source>
        <translation>第一个手指在夹爪中的位置</translation>
    </message>
    <message>
        <source>Place of the second finger in the gripper</source>
        <translation>第二个手指在夹爪中的位置</translation>
    </message>
    <message>
        <source>Where this finger&apos;s camera sits in the gripper.</source>
        <translation>该手指的相机在夹爪中的安装位置。</translation>
    </message>
    <message>
        <source>Distance between the faces</source>
        <translation>两个面之间的距离</translation>
    </message>
    <message>
        <source>How the two recordings are joined</source>
        <translation>两段录像的对应方式</translation>
    </message>
    <message>
        <source>Open a recording first; a second one can be joined to it.</source>
        <translation>请先打开一段录像，然后可以与第二段录像对应。</translation>
    </message>
    <message>
        <source>Joined by time stamps; 2 was taken %1 ms after 1.</source>
        <translation>按时间戳对应；2 比 1 晚 %1 ms 拍摄。</translation>
    </message>
    <message>
        <source>Recorded at different times: their beginnings count as one moment; 2 was taken %1 ms after 1.</source>
        <translation>录制时间不同：以各自的开头为同一时刻；2 比 1 晚 %1 ms 拍摄。</translation>
    </message>
    <message>
        <source>Without time stamps: joined by the number of the frame.</source>
        <translation>没有时间戳：按帧号对应。</translation>
    </message>
    <message>
        <source>Measuring the distance…</source>
        <translation>正在测量距离…</translation>
    </message>
    <message>
        <source>&lt;b&gt;The faces touch or cross.&lt;/b&gt;</source>
        <translation>&lt;b&gt;两个面相接触或相交。&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 mm&lt;/b&gt; between the faces where they are nearest, around X %2, Y %3, Z %4 mm</source>
        <translation>两个面最近处相距 &lt;b&gt;%1 mm&lt;/b&gt;，位于 X %2、Y %3、Z %4 mm 附近</translation>
    </message>
</context>
<context>
    <name>alltact::Pedal</name>
    <message>
        <source>Press it once more.</source>
        <translation>请再踩一次。</translation>
    </message>
    <message>
        <source>Press the pedal twice now.</source>
        <translation>请现在踩两次脚踏开关。</translation>
    </message>
    <message>
        <source>Leave the pedal alone for a moment.</source>
        <translation>请先不要踩脚踏开关。</translation>
    </message>
    <message>
        <source>Learnt: %1</source>
        <translation>已学习：%1</translation>
    </message>
</context>
<context>
    <name>alltact::ImagePanel</name>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>显示整个图像</translation>
    </message>
    <message>
        <source>Show the picture in its own size</source>
        <translation>按原始大小显示</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>Under the probe</source>
        <translation>探针处</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>The source is being opened.</source>
        <translation>正在打开来源。</translation>
    </message>
    <message>
        <source>The source could not be opened; above stands why.</source>
        <translation>无法打开来源；原因见上方。</translation>
    </message>
    <message>
        <source>No source is open. Choose a camera, a recording or the simulated finger.</source>
        <translation>没有打开来源。请选择相机、录像或仿真手指。</translation>
    </message>
    <message>
        <source>Waiting for the first picture.</source>
        <translation>正在等待第一帧。</translation>
    </message>
    <message>
        <source>Point at a pixel, or press Shift and an arrow key.</source>
        <translation>指向一个像素，或按 Shift 加方向键。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Freeze the picture</source>
        <translation>定格图像</translation>
    </message>
    <message>
        <source>Freeze: keep looking at this picture; measuring goes on</source>
        <translation>定格：继续查看这张图像，测量照常进行</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图像</translation>
    </message>
    <message>
        <source>Save the picture, with or without what is drawn over it</source>
        <translation>保存图像，可包含或不包含绘制在上面的内容</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>已定格</translation>
    </message>
</context>
<context>
    <name>alltact::PageHint</name>
    <message>
        <source>What this place is for</source>
        <translation>这个页面的用途</translation>
    </message>
    <message>
        <source>How it is &amp;done (F1)</source>
        <translation>操作方法(&amp;D)（F1）</translation>
    </message>
    <message>
        <source>&amp;Understood</source>
        <translation>明白了(&amp;U)</translation>
    </message>
</context>
<context>
    <name>alltact::PointsBox</name>
    <message>
        <source>move point A</source>
        <translation>移动点 A</translation>
    </message>
    <message>
        <source>take the points away</source>
        <translation>移除这些点</translation>
    </message>
    <message>
        <source>move point B</source>
        <translation>移动点 B</translation>
    </message>
    <message>
        <source>cut across</source>
        <translation>横向剖切</translation>
    </message>
    <message>
        <source>cut along</source>
        <translation>纵向剖切</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Point &amp;A</source>
        <translation>点 &amp;A</translation>
    </message>
    <message>
        <source>Point &amp;B</source>
        <translation>点 &amp;B</translation>
    </message>
    <message>
        <source>Point A, along the finger</source>
        <translation>点 A，沿手指方向</translation>
    </message>
    <message>
        <source>Point A, across it</source>
        <translation>点 A，横跨手指方向</translation>
    </message>
    <message>
        <source>Point B, along the finger</source>
        <translation>点 B，沿手指方向</translation>
    </message>
    <message>
        <source>Point B, across it</source>
        <translation>点 B，横跨手指方向</translation>
    </message>
    <message>
        <source>Along the face from its base. A point stays there on the finger while that moves.</source>
        <translation>沿面从根部算起。手指运动时，点停留在手指上的该处。</translation>
    </message>
    <message>
        <source>Across the face from its middle.</source>
        <translation>横跨面，从中线算起。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Deepest</source>
        <translation>最深处</translation>
    </message>
    <message>
        <source>Puts A on the deepest point.</source>
        <translation>把 A 放到最深点。</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Takes both points away.</source>
        <translation>移除两个点。</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>横向</translation>
    </message>
    <message>
        <source>From edge to edge of the finger, through A or the deepest point.</source>
        <translation>从手指的一边到另一边，经过 A 或最深点。</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>纵向</translation>
    </message>
    <message>
        <source>From base to tip, through A or the deepest point.</source>
        <translation>从根部到指尖，经过 A 或最深点。</translation>
    </message>
    <message>
        <source>Measured at the points</source>
        <translation>在这些点上测得</translation>
    </message>
    <message>
        <source>Nothing to measure yet.</source>
        <translation>还没有可测量的内容。</translation>
    </message>
</context>
<context>
    <name>alltact::PressCollection</name>
    <message>
        <source>change the ball&apos;s radius</source>
        <translation>更改球半径</translation>
    </message>
    <message>
        <source>change the ball&apos;s radius of %1</source>
        <translation>更改 %1 的球半径</translation>
    </message>
    <message>
        <source>change the operator</source>
        <translation>更改操作者</translation>
    </message>
    <message>
        <source>move the outline of %1</source>
        <translation>移动 %1 的轮廓</translation>
    </message>
    <message>
        <source>find the ball of %1</source>
        <translation>寻找 %1 的球</translation>
    </message>
    <message>
        <source>take out %1</source>
        <translation>取出 %1</translation>
    </message>
    <message>
        <source>put back %1</source>
        <translation>放回 %1</translation>
    </message>
    <message>
        <source>take %1</source>
        <translation>拍摄 %1</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message numerus="yes">
        <source>add %n picture(s)</source>
        <translation>
            <numerusform>添加 %n 张图片</numerusform>
        </translation>
    </message>
    <message>
        <source>There are presses of these names already: %1.</source>
        <translation>已有同名的按压：%1。</translation>
    </message>
    <message>
        <source>change the measured depth of %1</source>
        <translation>更改 %1 的测得深度</translation>
    </message>
    <message>
        <source>change the step of %1</source>
        <translation>更改 %1 的台阶</translation>
    </message>
    <message>
        <source>&amp;Put back</source>
        <translation>放回(&amp;P)</translation>
    </message>
    <message>
        <source>Take &amp;out</source>
        <translation>取出(&amp;O)</translation>
    </message>
</context>
<context>
    <name>alltact::PressErrorPlot</name>
    <message>
        <source>Error of every press, worst first</source>
        <translation>各次按压的误差，最大的在前</translation>
    </message>
    <message numerus="yes">
        <source>The worst of %n press(es) is %1 with %2 mm.</source>
        <translation>
            <numerusform>%n 次按压中最差的是 %1，%2 mm。</numerusform>
        </translation>
    </message>
    <message>
        <source>No presses yet</source>
        <translation>还没有按压</translation>
    </message>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1：%2 mm</translation>
    </message>
    <message>
        <source>No press is chosen</source>
        <translation>未选择按压</translation>
    </message>
    <message>
        <source>with this press in the mapping</source>
        <translation>映射中含此按压</translation>
    </message>
    <message>
        <source>without this press: its error</source>
        <translation>不含此按压：其误差</translation>
    </message>
    <message numerus="yes">
        <source>Mapping minus ball in the contact, mean (mm); %n better press(es) not shown</source>
        <translation>
            <numerusform>接触内映射减球的平均值 (mm)；另有 %n 次较好的按压未显示</numerusform>
        </translation>
    </message>
    <message>
        <source>Mapping minus ball in the contact, mean (mm)</source>
        <translation>接触内映射减球的平均值 (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::PressFitPane</name>
    <message>
        <source>Mapping − ball, mm</source>
        <translation>映射 − 球，mm</translation>
    </message>
    <message>
        <source>as the calibration puts it: %1</source>
        <translation>标定给出的位置：%1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mapping minus ball in this press</source>
        <translation>此次按压的映射减球</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mapping − ball here:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;此处的映射 − 球：&lt;/b&gt;%1</translation>
    </message>
</context>
<context>
    <name>alltact::PressForm</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Its ball</source>
        <translation>所用的球(&amp;I)</translation>
    </message>
    <message>
        <source>Radius of this press&apos; ball</source>
        <translation>此次按压所用球的半径</translation>
    </message>
    <message>
        <source>Where this press was made with a ball of another radius</source>
        <translation>如果此次按压用的是另一半径的球</translation>
    </message>
    <message>
        <source>Measured &amp;depth</source>
        <translation>测得深度(&amp;D)</translation>
    </message>
    <message>
        <source>Measured depth of this press</source>
        <translation>此次按压的测得深度</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>How deep the ball was pressed in, normal to the face, from where it first touches, as a stage or a feeler gauge tells it</source>
        <translation>球压入的深度，沿面的法线方向，从球刚接触处算起，由位移台或塞尺测得</translation>
    </message>
    <message>
        <source>&amp;Give or take</source>
        <translation>误差 ±(&amp;G)</translation>
    </message>
    <message>
        <source>Standard deviation of the measured depth</source>
        <translation>测得深度的标准差</translation>
    </message>
    <message>
        <source>How well the depth is known: the standard deviation of measuring it</source>
        <translation>深度的准确程度：测量的标准差</translation>
    </message>
    <message>
        <source>&amp;Step of a punch</source>
        <translation>压头台阶(&amp;S)</translation>
    </message>
    <message>
        <source>Step of a punch</source>
        <translation>压头台阶</translation>
    </message>
    <message>
        <source>a ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Height of the step of a flat punch that was pressed in instead of a ball; no ball is looked for then</source>
        <translation>代替球压入的平压头的台阶高度；此时不再寻找球</translation>
    </message>
</context>
<context>
    <name>alltact::PressLightPlot</name>
    <message>
        <source>Light of every press</source>
        <translation>各次按压的光照</translation>
    </message>
    <message>
        <source>No presses yet</source>
        <translation>还没有按压</translation>
    </message>
    <message>
        <source>Press, by number</source>
        <translation>按压编号</translation>
    </message>
    <message>
        <source>Light (%)</source>
        <translation>光照 (%)</translation>
    </message>
</context>
<context>
    <name>alltact::PressModel</name>
    <message>
        <source>taken out</source>
        <translation>已取出</translation>
    </message>
    <message>
        <source>taken out: %1</source>
        <translation>已取出：%1</translation>
    </message>
    <message>
        <source>ball put by hand</source>
        <translation>球由手动放置</translation>
    </message>
    <message>
        <source>being looked at</source>
        <translation>正在查看</translation>
    </message>
    <message>
        <source>ball found</source>
        <translation>已找到球</translation>
    </message>
    <message>
        <source>the ball&apos;s radius is missing</source>
        <translation>缺少球半径</translation>
    </message>
    <message>
        <source>a step of %1 mm reads %2 mm</source>
        <translation>%1 mm 的台阶读数为 %2 mm</translation>
    </message>
    <message>
        <source>a punch with a step of %1 mm</source>
        <translation>台阶为 %1 mm 的压头</translation>
    </message>
    <message>
        <source>measured %1 mm deep, the solution has %2 mm</source>
        <translation>测得深 %1 mm，解为 %2 mm</translation>
    </message>
    <message>
        <source>no face seen</source>
        <translation>看不到面</translation>
    </message>
    <message>
        <source>not comparable</source>
        <translation>无法比较</translation>
    </message>
    <message>
        <source>nothing pressed in</source>
        <translation>没有压入</translation>
    </message>
    <message>
        <source>only specks</source>
        <translation>只有斑点</translation>
    </message>
    <message>
        <source>two contacts</source>
        <translation>两处接触</translation>
    </message>
    <message>
        <source>larger than the ball</source>
        <translation>大于球</translation>
    </message>
    <message>
        <source>over the edge</source>
        <translation>超出边缘</translation>
    </message>
    <message>
        <source>no ball&apos;s disc</source>
        <translation>不是球的暗斑</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source>%1 mm deep, error %2 mm: %3</source>
        <translation>深 %1 mm，误差 %2 mm：%3</translation>
    </message>
    <message>
        <source>not written to the disk</source>
        <translation>未写入磁盘</translation>
    </message>
    <message>
        <source>%1 mm deep, error unknown</source>
        <translation>深 %1 mm，误差未知</translation>
    </message>
</context>
<context>
    <name>alltact::PressesPage</name>
    <message>
        <source>Presses</source>
        <translation>按压</translation>
    </message>
    <message>
        <source>&amp;Add pictures…</source>
        <translation>添加图片(&amp;A)…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>移除(&amp;M)</translation>
    </message>
    <message>
        <source>Takes the press and its picture away (undo brings them back)</source>
        <translation>移除按压及其图片（可撤销）</translation>
    </message>
    <message>
        <source>&amp;Live picture</source>
        <translation>实时画面(&amp;L)</translation>
    </message>
    <message>
        <source>Taking presses</source>
        <translation>拍摄按压</translation>
    </message>
    <message>
        <source>This press</source>
        <translation>此次按压</translation>
    </message>
    <message>
        <source>Ball&apos;s &amp;radius</source>
        <translation>球半径(&amp;R)</translation>
    </message>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>球半径</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>操作者(&amp;O)</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>for the record</source>
        <translation>用于记录</translation>
    </message>
    <message>
        <source>&amp;Take a press (Space)</source>
        <translation>拍摄按压（空格）(&amp;T)</translation>
    </message>
    <message>
        <source>By &amp;itself when it holds still</source>
        <translation>静止时自动拍摄(&amp;I)</translation>
    </message>
    <message>
        <source>Takes a press as soon as a contact holds still for half a second; both hands stay free</source>
        <translation>接触静止半秒后自动拍摄；双手不必离开</translation>
    </message>
    <message>
        <source>&amp;Find the ball again</source>
        <translation>重新寻找球(&amp;F)</translation>
    </message>
    <message>
        <source>Forgets where the outline was put by hand</source>
        <translation>忘记手动放置的轮廓位置</translation>
    </message>
    <message>
        <source>Yellow: the ball&apos;s outline, dashed as the program found it, whole where a hand put it. Blue: where the ball meets the untouched face, about the dark disc.</source>
        <translation>黄色：球的轮廓，虚线为程序找到的，实线为手动放置的。蓝色：球与未触碰面相交之处，大致是暗斑。</translation>
    </message>
    <message>
        <source>Place of the ball</source>
        <translation>球的位置</translation>
    </message>
    <message>
        <source>The presses are being read.</source>
        <translation>正在读取按压。</translation>
    </message>
    <message>
        <source>The ball&apos;s radius is missing.</source>
        <translation>缺少球半径。</translation>
    </message>
    <message>
        <source>Take a press first; six at different places are good.</source>
        <translation>请先拍摄一次按压；在不同位置拍六次为好。</translation>
    </message>
    <message>
        <source>In no press a ball was found yet.</source>
        <translation>还没有在任何按压中找到球。</translation>
    </message>
    <message>
        <source>There is no live picture: choose a source.</source>
        <translation>没有实时画面：请选择来源。</translation>
    </message>
    <message>
        <source>The finger cannot be compared with its reference.</source>
        <translation>无法将手指与其参考比较。</translation>
    </message>
    <message>
        <source>The live picture does not fit this finger.</source>
        <translation>实时画面与此手指不符。</translation>
    </message>
    <message>
        <source>Pictures of presses</source>
        <translation>按压图片</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</source>
        <translation>图片 (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</translation>
    </message>
    <message>
        <source>Try: %1.</source>
        <translation>请尝试：%1。</translation>
    </message>
    <message>
        <source>Or drag the outline onto the ball.</source>
        <translation>或者把轮廓拖到球上。</translation>
    </message>
    <message>
        <source>As it lies now it is pressed in by %1 mm.</source>
        <translation>按现在的位置，球压入 %1 mm。</translation>
    </message>
    <message>
        <source>As it lies now it does not touch the face.</source>
        <translation>按现在的位置，球没有碰到面。</translation>
    </message>
    <message>
        <source>Chosen &amp;press</source>
        <translation>所选按压(&amp;P)</translation>
    </message>
    <message>
        <source>A press that is taken out stays with the finger and is not used</source>
        <translation>取出的按压仍保存在手指中，但不使用</translation>
    </message>
    <message>
        <source>The picture is being read.</source>
        <translation>正在读取图片。</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px, %4 mm before the camera</source>
        <translation>中心 u %1 px，v %2 px，半径 %3 px，距相机 %4 mm</translation>
    </message>
    <message>
        <source>No ball is drawn here.</source>
        <translation>这里没有画球。</translation>
    </message>
    <message>
        <source>No press yet. Press the ball in at different places and depths, base, middle and tip.</source>
        <translation>还没有按压。请在不同位置以不同深度压入球：根部、中部和指尖。</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es), </source>
        <translation>
            <numerusform>%n 次按压，</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n usable</source>
        <translation>
            <numerusform>%n 次可用</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is taken: the mean of %2 pictures held still.</source>
        <translation>%1 已拍摄：%2 张静止画面的平均。</translation>
    </message>
    <message>
        <source>%1 is taken from a single picture; hold ball and finger still for half a second, and its noise falls to a quarter.</source>
        <translation>%1 取自单张画面；使球和手指保持静止半秒，噪声就会降到四分之一。</translation>
    </message>
    <message>
        <source>&amp;Error under the ball</source>
        <translation>球下的误差(&amp;E)</translation>
    </message>
    <message>
        <source>In colours, where the mapping reads deeper (red) or less deep (blue) than the ball is</source>
        <translation>用颜色表示映射比球读得更深（红）或更浅（蓝）的位置</translation>
    </message>
    <message>
        <source>Where to press next</source>
        <translation>接下来按压哪里</translation>
    </message>
    <message>
        <source>Measured, or another ball</source>
        <translation>已测量，或使用另一个球</translation>
    </message>
    <message>
        <source>Press %1</source>
        <translation>按压 %1</translation>
    </message>
    <message>
        <source>Waiting: it cannot be seen whether the face is touched.</source>
        <translation>等待：看不出面是否被触碰。</translation>
    </message>
    <message>
        <source>Waiting: nothing presses yet.</source>
        <translation>等待：还没有东西按压。</translation>
    </message>
    <message>
        <source>Waiting: the contact still moves, or is pressed in deeper.</source>
        <translation>等待：接触仍在移动，或正在加深。</translation>
    </message>
    <message>
        <source>Taken. Lift the ball, or move it by 2 mm, for the next one.</source>
        <translation>已采集。请抬起球，或移动 2 mm，再进行下一次。</translation>
    </message>
    <message>
        <source>Holds still.</source>
        <translation>保持不动。</translation>
    </message>
</context>
<context>
    <name>alltact::PressesPlot</name>
    <message>
        <source>Error of depth by the number of presses</source>
        <translation>深度误差随按压次数的变化</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es): %1 µm</source>
        <translation>
            <numerusform>%n 次按压：%1 µm</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is worked out yet</source>
        <translation>尚未计算</translation>
    </message>
    <message>
        <source>painted balls, whisker to 95 %</source>
        <translation>画入的球，线段到 95 %</translation>
    </message>
    <message>
        <source>presses there are now</source>
        <translation>现有的按压</translation>
    </message>
    <message>
        <source>real presses left out</source>
        <translation>被排除的真实按压</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>按压次数</translation>
    </message>
    <message>
        <source>Error of depth (µm)</source>
        <translation>深度误差 (µm)</translation>
    </message>
</context>
<context>
    <name>alltact::NotificationBar</name>
    <message>
        <source>The program ended unexpectedly last time.</source>
        <translation>程序上次意外退出。</translation>
    </message>
    <message>
        <source>What was worked on is kept.</source>
        <translation>之前的工作已保留。</translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation>继续上次的工作(&amp;G)</translation>
    </message>
    <message>
        <source>The foot pedal is not heard now.</source>
        <translation>现在收不到脚踏开关的信号。</translation>
    </message>
    <message>
        <source>The source has ended; its last picture is shown.</source>
        <translation>来源已结束；显示的是最后一帧。</translation>
    </message>
    <message>
        <source>&amp;Play it again</source>
        <translation>重新播放(&amp;P)</translation>
    </message>
</context>
<context>
    <name>alltact::ProblemList</name>
    <message>
        <source>Try: %1</source>
        <translation>建议：%1</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Dismiss until it happens again</source>
        <translation>忽略，直到再次发生</translation>
    </message>
    <message>
        <source>Dismiss: %1</source>
        <translation>忽略：%1</translation>
    </message>
    <message>
        <source>now</source>
        <translation>刚刚</translation>
    </message>
    <message numerus="yes">
        <source>%n min ago</source>
        <translation>
            <numerusform>%n 分钟前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n h ago</source>
        <translation>
            <numerusform>%n 小时前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>另有 %n 条</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the newest alone</source>
        <translation>只显示最新一条</translation>
    </message>
    <message>
        <source>Show all in full</source>
        <translation>完整显示全部</translation>
    </message>
</context>
<context>
    <name>alltact::QuickGuide</name>
    <message>
        <source>AllTact Studio: quick guide</source>
        <translation>AllTact Studio：快速指南</translation>
    </message>
</context>
<context>
    <name>alltact::NavigationBar</name>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Ctrl+%2)</translation>
    </message>
</context>
<context>
    <name>alltact::ReadingWords</name>
    <message>
        <source>no depth: too dark</source>
        <translation>无深度：过暗</translation>
    </message>
    <message>
        <source>no depth: too bright</source>
        <translation>无深度：过亮</translation>
    </message>
    <message>
        <source>no depth: near the face&apos;s edge</source>
        <translation>无深度：靠近面的边缘</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>深度 %1 mm</translation>
    </message>
    <message>
        <source>at the layer&apos;s limit</source>
        <translation>达到涂层极限</translation>
    </message>
    <message>
        <source>a bulge at the layer&apos;s limit</source>
        <translation>隆起达到涂层极限</translation>
    </message>
    <message>
        <source>beyond what was calibrated</source>
        <translation>超出标定范围</translation>
    </message>
    <message>
        <source>steep: a pixel sideways changes it by more</source>
        <translation>陡坡：偏移一个像素的变化更大</translation>
    </message>
    <message>
        <source>doubtful light</source>
        <translation>光照可疑</translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation>（%1）</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: off the face</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;：不在面上</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: x %2, y %3, z %4 mm</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;:x %2、y %3、z %4 mm</translation>
    </message>
    <message>
        <source>&lt;b&gt;A to B&lt;/b&gt;: %1 mm straight, %2 mm over the face</source>
        <translation>&lt;b&gt;A 到 B&lt;/b&gt;：直线 %1 mm，沿面 %2 mm</translation>
    </message>
    <message>
        <source>by x %1, y %2, z %3 mm</source>
        <translation>x %1、y %2、z %3 mm</translation>
    </message>
    <message>
        <source>Deepest %1 mm; contact at x %2, y %3, z %4 mm.</source>
        <translation>最深 %1 mm；接触位置 x %2、y %3、z %4 mm。</translation>
    </message>
    <message>
        <source>Nothing presses on the face.</source>
        <translation>面上没有受压。</translation>
    </message>
    <message>
        <source>Click on the face for point A, with the right button for point B.</source>
        <translation>在面上单击设置 A 点，右键单击设置 B 点。</translation>
    </message>
    <message>
        <source>not calibrated: no depth</source>
        <translation>未标定：没有深度</translation>
    </message>
    <message>
        <source>%1 mm along, %2 mm across; x %3, y %4, z %5 mm</source>
        <translation>纵向 %1 mm，横向 %2 mm；x %3，y %4，z %5 mm</translation>
    </message>
</context>
<context>
    <name>alltact::RecordPage</name>
    <message>
        <source>Bend it in all directions</source>
        <translation>向各个方向弯曲</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>What was recorded</source>
        <translation>录制内容</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>File to record to</source>
        <translation>录制到的文件</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>选择(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Install as this finger&apos;s reference</source>
        <translation>设为此手指的参考(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Stops the installation; nothing is changed.</source>
        <translation>停止安装；不作任何更改。</translation>
    </message>
    <message>
        <source>Progress of the installation</source>
        <translation>安装进度</translation>
    </message>
    <message>
        <source>Frames that were left out, with the reason</source>
        <translation>被舍弃的帧及原因</translation>
    </message>
    <message>
        <source>Tick frames that were untouched, and install again.</source>
        <translation>勾选实际未接触的帧，然后重新安装。</translation>
    </message>
    <message>
        <source>It was cleaned, painted or replaced: the last reference then does not tell what pressed on it.</source>
        <translation>表皮经过清洁、涂漆或更换：上次的参考便无法说明有什么按压过它。</translation>
    </message>
    <message>
        <source>The &amp;skin was changed since the last reference</source>
        <translation>自上次参考以来表皮已改变(&amp;S)</translation>
    </message>
    <message>
        <source>The markers have to be seen to tell how it bends.</source>
        <translation>必须看得见标记点才能判断弯曲。</translation>
    </message>
    <message>
        <source>Enough: all directions are reached.</source>
        <translation>足够：所有方向都已达到。</translation>
    </message>
    <message>
        <source>Still missing: %1.</source>
        <translation>还缺少：%1。</translation>
    </message>
    <message>
        <source>What was found in the recording</source>
        <translation>录像中找到的内容</translation>
    </message>
    <message>
        <source>A picture shows what was found in the recording, and what was not.</source>
        <translation>一张图片显示录像中找到了什么、没找到什么。</translation>
    </message>
    <message>
        <source>Show the picture</source>
        <translation>显示图片</translation>
    </message>
    <message>
        <source>Set res&amp;t pose</source>
        <translation>设定静止姿态(&amp;T)</translation>
    </message>
    <message>
        <source>The finger hangs free now: all bending is told from here.</source>
        <translation>手指现在自由悬垂：所有弯曲都从这里算起。</translation>
    </message>
    <message>
        <source>Bending is told from the rest pose that was set.</source>
        <translation>弯曲从设定的静止姿态算起。</translation>
    </message>
    <message>
        <source>Bending is told from the middle of all poses.</source>
        <translation>弯曲从所有姿态的中间算起。</translation>
    </message>
    <message>
        <source>Record to</source>
        <translation>录制到</translation>
    </message>
    <message>
        <source>Video (*.mkv)</source>
        <translation>视频 (*.mkv)</translation>
    </message>
    <message>
        <source>The recording is being installed.</source>
        <translation>正在安装录像。</translation>
    </message>
    <message>
        <source>The last frames are being written.</source>
        <translation>正在写入最后几帧。</translation>
    </message>
    <message>
        <source>Open a source first: a camera, or the simulated finger.</source>
        <translation>请先打开来源：相机或仿真手指。</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>停止录制(&amp;R)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Recording&lt;/b&gt; %1 min&lt;br&gt;%2, %3, %4 GB</source>
        <translation>&lt;b&gt;正在录制&lt;/b&gt; %1 分钟&lt;br&gt;%2，%3，%4 GB</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n 帧</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lost</source>
        <translation>
            <numerusform>丢失 %n 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>Space left: %1 GB</source>
        <translation>剩余空间：%1 GB</translation>
    </message>
    <message>
        <source>Open the finger that was recorded first.</source>
        <translation>请先打开被录制的手指。</translation>
    </message>
    <message>
        <source>A flat sensor has one untouched picture instead of a recording.</source>
        <translation>平面传感器只需一张未接触的图片，不需要录像。</translation>
    </message>
    <message>
        <source>A recording is under way.</source>
        <translation>正在录制。</translation>
    </message>
    <message>
        <source>%1: %2, %3 min</source>
        <translation>%1：%2，%3 分钟</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were lost because this computer or its disk was too slow.</source>
        <translation>
            <numerusform>由于本机或磁盘太慢，丢失了 %n 帧。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) never came from the source.</source>
        <translation>
            <numerusform>有 %n 帧从未由来源送达。</numerusform>
        </translation>
    </message>
    <message>
        <source>No frame was lost.</source>
        <translation>没有丢帧。</translation>
    </message>
    <message>
        <source>Reading the recording…</source>
        <translation>正在读取录像…</translation>
    </message>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>大约还剩 %n 秒。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Installed: %1 of %n frame(s) are in the reference.</source>
        <translation>
            <numerusform>已安装：%n 帧中有 %1 帧进入参考。</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out, with the reason:</source>
        <translation>被舍弃的帧及原因：</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) of this recording are lost.</source>
        <translation>
            <numerusform>本次录制丢失了 %n 帧。</numerusform>
        </translation>
    </message>
    <message>
        <source>Try another disk, or a smaller picture.</source>
        <translation>请换用其他磁盘或更小的图像。</translation>
    </message>
    <message>
        <source>Keep it free: bend the finger at its tip, its sides or its back.</source>
        <translation>请保持其空闲：从指尖、侧面或背面弯曲手指。</translation>
    </message>
    <message>
        <source>Little space is left on the disk.</source>
        <translation>磁盘剩余空间不足。</translation>
    </message>
    <message>
        <source>Choose a file on another disk, or make room.</source>
        <translation>请选择其他磁盘上的文件，或清理空间。</translation>
    </message>
    <message>
        <source>Start &amp;recording</source>
        <translation>开始录制(&amp;R)</translation>
    </message>
    <message>
        <source>What it leaves open: half of the references made from it are off by less than %1 mm, 95 % by less than %2 mm.</source>
        <translation>剩余误差：由此得到的参考，一半偏差小于 %1 mm,95 % 小于 %2 mm。</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) showed a pose that others show as well.</source>
        <translation>
            <numerusform>有 %n 帧与其他帧姿态相同。</numerusform>
        </translation>
    </message>
    <message>
        <source>It cannot be seen whether the contact face is touched.</source>
        <translation>无法判断接触面是否被触碰。</translation>
    </message>
    <message>
        <source>Open the finger that belongs to this source, and keep both edges of its face in the picture.</source>
        <translation>请打开属于此来源的手指，并使其表面的两条边缘都在画面内。</translation>
    </message>
    <message>
        <source>Before there is a reference, touching is told from the frames before.</source>
        <translation>在有参考之前，根据先前的画面判断是否被触碰。</translation>
    </message>
    <message>
        <source>Begin with nothing on the contact face.</source>
        <translation>请在接触面没有任何东西时开始。</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>录制(&amp;R)</translation>
    </message>
    <message>
        <source>This finger has no reference recording yet.</source>
        <translation>此手指还没有参考录像。</translation>
    </message>
    <message>
        <source>Record it bending, with nothing on its contact face.</source>
        <translation>请录制它弯曲的过程，接触面上不要有任何东西。</translation>
    </message>
    <message>
        <source>It was not twisted; twist it, too, if it is in use.</source>
        <translation>没有扭转过；如果使用中会扭转，也请扭转。</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>留待以后(&amp;K)</translation>
    </message>
    <message>
        <source>The video stays where it is, and the finger stays as it is.</source>
        <translation>视频留在原处，手指保持不变。</translation>
    </message>
    <message>
        <source>Record a&amp;gain</source>
        <translation>重新录制(&amp;G)</translation>
    </message>
    <message>
        <source>Puts this video into the waste bin and records another one.</source>
        <translation>把这段视频移到回收站，并重新录制一段。</translation>
    </message>
    <message>
        <source>Install a &amp;video that is there…</source>
        <translation>安装已有的视频(&amp;V)…</translation>
    </message>
    <message>
        <source>Follow the outline: %1</source>
        <translation>请跟随轮廓：%1</translation>
    </message>
    <message>
        <source>Video of the bending finger</source>
        <translation>手指弯曲的视频</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.avi *.mp4 *.mov)</source>
        <translation>视频 (*.mkv *.avi *.mp4 *.mov)</translation>
    </message>
    <message numerus="yes">
        <source>Touched in %n frame(s), which are left out.</source>
        <translation>
            <numerusform>有 %n 帧被触碰，已排除。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What it would bring is being worked out, about %n second(s).</source>
        <translation>
            <numerusform>正在计算它会带来什么，大约 %n 秒。</numerusform>
        </translation>
    </message>
    <message>
        <source>What it would bring is being worked out.</source>
        <translation>正在计算它会带来什么。</translation>
    </message>
    <message>
        <source>It cannot be installed: %1</source>
        <translation>无法安装：%1</translation>
    </message>
    <message numerus="yes">
        <source>It would bring: half of the references off by less than %1 mm, 95 % by less than %2 mm, from %n frame(s).</source>
        <translation>
            <numerusform>它会带来：一半的参考偏差小于 %1 mm，95 % 小于 %2 mm，来自 %n 帧。</numerusform>
        </translation>
    </message>
    <message>
        <source>Kept: %1</source>
        <translation>已保留：%1</translation>
    </message>
    <message>
        <source>Ctrl+R, or Space</source>
        <translation>Ctrl+R 或空格键</translation>
    </message>
    <message>
        <source>The contact face is touched; such frames are left out.</source>
        <translation>接触面被触碰；这样的帧会被排除。</translation>
    </message>
    <message>
        <source>&amp;Go to Calibrate</source>
        <translation>前往“标定”(&amp;G)</translation>
    </message>
    <message>
        <source>The finger is being read with its new reference.</source>
        <translation>正在用新参考读取手指。</translation>
    </message>
    <message numerus="yes">
        <source>room for about %n minute(s)</source>
        <translation>
            <numerusform>约可录 %n 分钟</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::RigCheckBox</name>
    <message>
        <source>Focus at the base</source>
        <translation>根部对焦</translation>
    </message>
    <message>
        <source>Focus at the tip</source>
        <translation>指尖对焦</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>灯</translation>
    </message>
    <message>
        <source>Dots</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Before the first recording</source>
        <translation>首次录制之前</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>Camera: nothing sets itself.</source>
        <translation>相机：没有自动调节项。</translation>
    </message>
    <message>
        <source>Camera: %1 is on and changes the brightness that is measured. Lock brightness in Live, or switch it off there.</source>
        <translation>相机：%1 已开启，会改变被测量的亮度。请在“实时”中锁定亮度，或在那里将其关闭。</translation>
    </message>
    <message numerus="yes">
        <source>Before the first recording: %n to mend</source>
        <translation>
            <numerusform>首次录制之前：有 %n 项需要处理</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::SaveBar</name>
    <message>
        <source>Mesh, PLY</source>
        <translation>网格，PLY</translation>
    </message>
    <message>
        <source>Mesh, VTP (VTK)</source>
        <translation>网格，VTP (VTK)</translation>
    </message>
    <message>
        <source>Mesh, STL</source>
        <translation>网格，STL</translation>
    </message>
    <message>
        <source>Mesh, glTF</source>
        <translation>网格，glTF</translation>
    </message>
    <message>
        <source>Video in 3D, MKV</source>
        <translation>三维视频，MKV</translation>
    </message>
    <message>
        <source>What is saved</source>
        <translation>保存的内容</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Progress of saving</source>
        <translation>保存进度</translation>
    </message>
    <message>
        <source>Picture, PNG (300 dpi)</source>
        <translation>图片，PNG（300 dpi）</translation>
    </message>
    <message>
        <source>Cross-section, PDF</source>
        <translation>剖面，PDF</translation>
    </message>
    <message>
        <source>Cross-section, SVG</source>
        <translation>剖面，SVG</translation>
    </message>
    <message>
        <source>Cross-section, CSV</source>
        <translation>剖面，CSV</translation>
    </message>
</context>
<context>
    <name>alltact::SecondCameraDialog</name>
    <message>
        <source>The second finger&apos;s folder</source>
        <translation>第二个手指的文件夹</translation>
    </message>
    <message>
        <source>What shows the second finger</source>
        <translation>显示第二个手指的来源</translation>
    </message>
    <message>
        <source>Videos and scenes (*.mkv *.avi *.mp4 *.yaml *.yml)</source>
        <translation>视频和场景 (*.mkv *.avi *.mp4 *.yaml *.yml)</translation>
    </message>
    <message>
        <source>The gripper&apos;s file</source>
        <translation>夹爪文件</translation>
    </message>
    <message>
        <source>Grippers (*.yaml)</source>
        <translation>夹爪 (*.yaml)</translation>
    </message>
    <message>
        <source>Second finger</source>
        <translation>第二个手指</translation>
    </message>
    <message>
        <source>Another finger of the same gripper with its own camera. Both pictures are shown as of one moment; with a gripper.yaml the gap between the faces and the width of what is held are told, too.</source>
        <translation>同一夹爪的另一个手指，带有自己的相机。两幅图像按同一时刻显示；有 gripper.yaml 时，还会给出两个面之间的间隙和所夹物体的宽度。</translation>
    </message>
    <message>
        <source>&amp;Finger&apos;s folder</source>
        <translation>手指文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>相机(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Gripper</source>
        <translation>夹爪(&amp;G)</translation>
    </message>
    <message>
        <source>Finger&apos;s folder</source>
        <translation>手指文件夹</translation>
    </message>
    <message>
        <source>Camera, video or scene</source>
        <translation>相机、视频或场景</translation>
    </message>
    <message>
        <source>Gripper&apos;s file</source>
        <translation>夹爪文件</translation>
    </message>
    <message>
        <source>gripper.yaml; may be left empty</source>
        <translation>gripper.yaml；可以留空</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder</source>
        <translation>选择手指文件夹</translation>
    </message>
    <message>
        <source>Choose a video or a scene</source>
        <translation>选择视频或场景</translation>
    </message>
    <message>
        <source>Choose the gripper&apos;s file</source>
        <translation>选择夹爪文件</translation>
    </message>
    <message>
        <source>&amp;Show it</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder.</source>
        <translation>请选择手指文件夹。</translation>
    </message>
    <message>
        <source>Choose the camera that watches it.</source>
        <translation>请选择观察该手指的相机。</translation>
    </message>
</context>
<context>
    <name>alltact::SecondFingerDialog</name>
    <message>
        <source>The second finger&apos;s folder</source>
        <translation>第二个手指的文件夹</translation>
    </message>
    <message>
        <source>The second finger&apos;s video</source>
        <translation>第二个手指的视频</translation>
    </message>
    <message>
        <source>The second finger&apos;s folder of pictures</source>
        <translation>第二个手指的图像文件夹</translation>
    </message>
    <message>
        <source>Second finger</source>
        <translation>第二个手指</translation>
    </message>
    <message>
        <source>Another finger of the same gripper, with what it recorded at the same time. Both are shown in the gripper&apos;s frame; their frames are joined by the times of capture.</source>
        <translation>同一夹爪的另一个手指及其同时录制的内容。两者显示在夹爪坐标系中；各帧按拍摄时间对应。</translation>
    </message>
    <message>
        <source>&amp;Finger&apos;s folder</source>
        <translation>手指文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Recording</source>
        <translation>录像(&amp;R)</translation>
    </message>
    <message>
        <source>Finger&apos;s folder</source>
        <translation>手指文件夹</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录像</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder</source>
        <translation>选择手指文件夹</translation>
    </message>
    <message>
        <source>Video…</source>
        <translation>视频…</translation>
    </message>
    <message>
        <source>Pictures…</source>
        <translation>图像…</translation>
    </message>
    <message>
        <source>&amp;Show it</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.avi *.mp4)</source>
        <translation>视频 (*.mkv *.avi *.mp4)</translation>
    </message>
    <message>
        <source>Choose the finger&apos;s folder.</source>
        <translation>请选择手指文件夹。</translation>
    </message>
    <message>
        <source>Choose what it recorded.</source>
        <translation>请选择其录制的内容。</translation>
    </message>
</context>
<context>
    <name>alltact::SectionPlot</name>
    <message>
        <source>Depth from A to B</source>
        <translation>A 到 B 的深度</translation>
    </message>
    <message>
        <source>Choose two points, A and B</source>
        <translation>选择 A、B 两点</translation>
    </message>
    <message>
        <source>From A over the face (mm)</source>
        <translation>从 A 沿面的距离 (mm)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>深度 (mm)</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>当前显示</translation>
    </message>
</context>
<context>
    <name>alltact::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Foot pedal</source>
        <translation>脚踏开关(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>无(&amp;N)</translation>
    </message>
    <message>
        <source>Listens to no pedal any more.</source>
        <translation>不再使用脚踏开关。</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Learn by pressing it…</source>
        <translation>踩踏以学习(&amp;L)…</translation>
    </message>
    <message>
        <source>Stop learning the foot pedal</source>
        <translation>停止学习脚踏开关</translation>
    </message>
    <message>
        <source>Learn the foot pedal by pressing it</source>
        <translation>通过踩踏学习脚踏开关</translation>
    </message>
    <message>
        <source>None. A pedal takes presses in Calibrate, and starts and stops in Record.</source>
        <translation>无。脚踏开关在“标定”中采集按压，在“录制”中开始和停止。</translation>
    </message>
    <message>
        <source>%1: not heard now</source>
        <translation>%1：现在收不到信号</translation>
    </message>
</context>
<context>
    <name>alltact::SettingsWords</name>
    <message>
        <source>every pixel</source>
        <translation>全部像素</translation>
    </message>
    <message>
        <source>half the pixels a side</source>
        <translation>每边一半像素</translation>
    </message>
    <message>
        <source>a quarter of the pixels a side</source>
        <translation>每边四分之一像素</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) averaged</source>
        <translation>
            <numerusform>%n 张图像取平均</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reference from %n picture(s)</source>
        <translation>
            <numerusform>参考取自 %n 张图像</numerusform>
        </translation>
    </message>
    <message>
        <source>edges at whole pixels</source>
        <translation>边缘取整像素</translation>
    </message>
    <message>
        <source>edges between pixels</source>
        <translation>边缘取亚像素</translation>
    </message>
    <message numerus="yes">
        <source>edges from %n column(s)</source>
        <translation>
            <numerusform>边缘取自 %n 列</numerusform>
        </translation>
    </message>
    <message>
        <source>edge curve of degree %1</source>
        <translation>边缘曲线为 %1 次</translation>
    </message>
    <message>
        <source>markers as two sorted rows</source>
        <translation>标记点按两行排序</translation>
    </message>
    <message>
        <source>markers found by a network</source>
        <translation>标记点由网络查找</translation>
    </message>
    <message>
        <source>markers followed as spots</source>
        <translation>标记点按斑点跟踪</translation>
    </message>
    <message>
        <source>compared with the picture at rest</source>
        <translation>与静止时的图像比较</translation>
    </message>
    <message>
        <source>compared with the nearest picture</source>
        <translation>与最接近的图像比较</translation>
    </message>
    <message>
        <source>compared with several pictures</source>
        <translation>与多张图像比较</translation>
    </message>
    <message>
        <source>light taken as recorded</source>
        <translation>光照视为与录像相同</translation>
    </message>
    <message>
        <source>light corrected</source>
        <translation>光照已校正</translation>
    </message>
    <message>
        <source>no smoothing</source>
        <translation>不平滑</translation>
    </message>
    <message>
        <source>smoothing of %1 px</source>
        <translation>平滑 %1 px</translation>
    </message>
    <message>
        <source>lens taken as one that bends nothing</source>
        <translation>将镜头视为无畸变</translation>
    </message>
    <message>
        <source>lens corrected at every point</source>
        <translation>逐点校正镜头</translation>
    </message>
    <message>
        <source>parallel rays through the layer</source>
        <translation>穿过层的平行光线</translation>
    </message>
    <message>
        <source>exact rays through the layer</source>
        <translation>穿过层的精确光线</translation>
    </message>
</context>
<context>
    <name>alltact::SheetWords</name>
    <message>
        <source>Finger %1: what its calibration is worth</source>
        <translation>手指 %1：其标定的价值</translation>
    </message>
    <message numerus="yes">
        <source>%1, ball of radius %2 mm, %n press(es), AllTact %3</source>
        <translation>
            <numerusform>%1，球半径 %2 mm，%n 次按压，AllTact %3</numerusform>
        </translation>
    </message>
    <message>
        <source>By zone of the face: %1.</source>
        <translation>按面的区域：%1。</translation>
    </message>
    <message>
        <source>The presses show a fault</source>
        <translation>按压显示有故障</translation>
    </message>
    <message>
        <source>From brightness to depth: each point is a block of pixels under a ball.</source>
        <translation>从亮度到深度：每个点是球下的一块像素。</translation>
    </message>
    <message>
        <source>Where on the face, and how far the mapping is off there.</source>
        <translation>面上的位置，以及映射在该处的偏差。</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>按压</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>深度 (mm)</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>误差 (mm)</translation>
    </message>
    <message numerus="yes">
        <source>And %n press(es) more, in the report.</source>
        <translation>
            <numerusform>另有 %n 次按压，见报告。</numerusform>
        </translation>
    </message>
    <message>
        <source>Print the verdict</source>
        <translation>打印结论</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>alltact::SettingsComparison</name>
    <message>
        <source>Depth with the setting in use now</source>
        <translation>用当前设置得到的深度</translation>
    </message>
    <message>
        <source>Depth with the chosen setting</source>
        <translation>用所选设置得到的深度</translation>
    </message>
    <message>
        <source>Difference of the two depths</source>
        <translation>两个深度的差值</translation>
    </message>
    <message>
        <source>Both settings in figures</source>
        <translation>两种设置的数值</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>深度 (mm)</translation>
    </message>
    <message>
        <source>In use now: %1</source>
        <translation>当前使用：%1</translation>
    </message>
    <message>
        <source>Chosen: %1</source>
        <translation>所选：%1</translation>
    </message>
    <message>
        <source>Chosen less in use</source>
        <translation>所选减当前</translation>
    </message>
    <message>
        <source>Choose a setting other than the one in use.</source>
        <translation>请选择与当前不同的设置。</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>正在测量…</translation>
    </message>
    <message>
        <source>Open a camera or a recording first.</source>
        <translation>请先打开相机或录像。</translation>
    </message>
    <message>
        <source>One of them tells no depth in this picture.</source>
        <translation>其中一个在这张图像中没有给出深度。</translation>
    </message>
    <message>
        <source>Difference (mm)</source>
        <translation>差值 (mm)</translation>
    </message>
    <message>
        <source>This picture: %1 ms with the setting in use, %2 ms with the chosen one.</source>
        <translation>这张图像：当前设置 %1 ms，所选设置 %2 ms。</translation>
    </message>
    <message>
        <source>Where something presses, half of all points differ by less than %1 µm, 95 % by less than %2 µm.</source>
        <translation>在有按压处，一半的点相差小于 %1 µm，95 % 小于 %2 µm。</translation>
    </message>
    <message>
        <source>Nothing presses: touch the finger to see depths differ.</source>
        <translation>没有按压：请触碰手指，以查看深度的差别。</translation>
    </message>
</context>
<context>
    <name>alltact::SnapshotWords</name>
    <message>
        <source>Save the picture</source>
        <translation>保存图像</translation>
    </message>
    <message>
        <source>As it is shown (*.png)</source>
        <translation>按显示的样子 (*.png)</translation>
    </message>
    <message>
        <source>The camera&apos;s picture alone (*.png)</source>
        <translation>仅相机图像 (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose another folder, or make room on the disk.</source>
        <translation>无法写入 %1。请选择其他文件夹，或腾出磁盘空间。</translation>
    </message>
</context>
<context>
    <name>alltact::SourceMenu</name>
    <message>
        <source>&amp;Source</source>
        <translation>来源(&amp;S)</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>No camera is plugged in</source>
        <translation>未连接相机</translation>
    </message>
    <message>
        <source>&amp;Simulated finger</source>
        <translation>仿真手指(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Video file…</source>
        <translation>视频文件(&amp;V)…</translation>
    </message>
    <message>
        <source>Folder of &amp;pictures…</source>
        <translation>图片文件夹(&amp;P)…</translation>
    </message>
    <message>
        <source>Scene &amp;file…</source>
        <translation>场景文件(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Close the source</source>
        <translation>关闭来源(&amp;C)</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>打开视频</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.avi *.mp4)</source>
        <translation>视频 (*.mkv *.avi *.mp4)</translation>
    </message>
    <message>
        <source>Open a folder of pictures</source>
        <translation>打开图片文件夹</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>打开场景</translation>
    </message>
    <message>
        <source>Scenes (*.yaml *.yml)</source>
        <translation>场景 (*.yaml *.yml)</translation>
    </message>
</context>
<context>
    <name>alltact::StartPanel</name>
    <message>
        <source>What shall be shown?</source>
        <translation>要显示什么？</translation>
    </message>
    <message>
        <source>Choose where pictures come from. A finger can be opened before or after.</source>
        <translation>选择图像的来源。手指可以之前或之后再打开。</translation>
    </message>
    <message>
        <source>&amp;Simulated finger</source>
        <translation>仿真手指(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Video file…</source>
        <translation>视频文件(&amp;V)…</translation>
    </message>
    <message>
        <source>Folder of &amp;pictures…</source>
        <translation>图片文件夹(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Open a finger…</source>
        <translation>打开手指(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;New finger…</source>
        <translation>新建手指(&amp;N)…</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>手指</translation>
    </message>
    <message>
        <source>&amp;Go on with %1</source>
        <translation>继续：%1(&amp;G)</translation>
    </message>
    <message>
        <source>No camera is plugged in.</source>
        <translation>未连接相机。</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>&amp;Try with a simulated finger</source>
        <translation>用仿真手指试用(&amp;T)</translation>
    </message>
    <message>
        <source>A whole day in five minutes: record, press, calibrate and check a finger that is computed</source>
        <translation>五分钟体验完整的一天：对一个由计算生成的手指进行录制、按压、标定和检查</translation>
    </message>
    <message>
        <source>&amp;All fingers…</source>
        <translation>全部手指(&amp;A)…</translation>
    </message>
    <message>
        <source>What each is worth, and what is due, in one list</source>
        <translation>每个手指的评价和待办事项，列在一处</translation>
    </message>
    <message>
        <source>A finger from its side: camera and lamps at its base, and a ball that presses</source>
        <translation>手指的侧视图：根部有相机和灯，一个球正在按压</translation>
    </message>
</context>
<context>
    <name>alltact::StatusLine</name>
    <message>
        <source>Frames delivered</source>
        <translation>收到的帧</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>Time of a frame</source>
        <translation>每帧用时</translation>
    </message>
    <message>
        <source>%1 ms a frame</source>
        <translation>每帧 %1 ms</translation>
    </message>
    <message>
        <source>%1 frames/s, %2 delivered, %3 shown a second</source>
        <translation>%1 帧/秒，已收到 %2 帧，每秒显示 %3 帧</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>丢失 %n 帧</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::StepList</name>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>look again</source>
        <translation>请再看</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>待办</translation>
    </message>
    <message>
        <source>is being read</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a step&apos;s number and title</comment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>alltact::SurfaceBox</name>
    <message>
        <source>Between A and B</source>
        <translation>A 与 B 之间</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>复制为 CSV</translation>
    </message>
    <message>
        <source>Measured between the points</source>
        <translation>两点之间的测量值</translation>
    </message>
    <message>
        <source>Two points make a box: a ball&apos;s radius, area, volume, roughness; the distance, the step and the angle from A to B.</source>
        <translation>两个点构成一个方框：球的半径、面积、体积、粗糙度；从 A 到 B 的距离、台阶和角度。</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>复制为文本</translation>
    </message>
</context>
<context>
    <name>alltact::SurfaceWords</name>
    <message>
        <source>Ball&apos;s radius</source>
        <translation>球半径</translation>
    </message>
    <message>
        <source>Pressed area</source>
        <translation>压入面积</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Mean depth</source>
        <translation>平均深度</translation>
    </message>
    <message>
        <source>Roughness Sq</source>
        <translation>粗糙度 Sq</translation>
    </message>
    <message>
        <source>Step from A to B</source>
        <translation>从 A 到 B 的台阶</translation>
    </message>
    <message>
        <source>Angle of A to B</source>
        <translation>从 A 到 B 的角度</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Distance A to B</source>
        <translation>A 到 B 的距离</translation>
    </message>
</context>
<context>
    <name>alltact::TimeLine</name>
    <message>
        <source>Frame of the recording</source>
        <translation>录像的帧</translation>
    </message>
    <message>
        <source>Number of the frame</source>
        <translation>帧号</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1</translation>
    </message>
    <message>
        <source>Name of the frame</source>
        <translation>帧名</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Previous contact or problem</source>
        <translation>上一个接触或问题</translation>
    </message>
    <message>
        <source>Next contact or problem</source>
        <translation>下一个接触或问题</translation>
    </message>
</context>
<context>
    <name>alltact::Tutorial</name>
    <message>
        <source>A day with a simulated finger</source>
        <translation>仿真手指的一天</translation>
    </message>
    <message>
        <source>End the &amp;guide</source>
        <translation>结束引导(&amp;G)</translation>
    </message>
    <message>
        <source>Done:</source>
        <translation>完成：</translation>
    </message>
    <message>
        <source>%1 of %2:</source>
        <translation>第 %1 步，共 %2 步：</translation>
    </message>
    <message>
        <source>Go to &amp;Record</source>
        <translation>转到录制(&amp;R)</translation>
    </message>
    <message>
        <source>Go to &amp;Inspect</source>
        <translation>转到检视(&amp;I)</translation>
    </message>
    <message>
        <source>Go to &amp;Calibrate</source>
        <translation>转到标定(&amp;C)</translation>
    </message>
    <message>
        <source>The simulated finger gets a folder of its own.</source>
        <translation>仿真手指将有自己的文件夹。</translation>
    </message>
    <message>
        <source>Record it for half a minute while it bends, then install the recording.</source>
        <translation>请录制它弯曲的过程半分钟，然后将录像设为参考。</translation>
    </message>
    <message>
        <source>Tell the ball&apos;s radius, 4 mm, and press Space whenever the ball is in: six times.</source>
        <translation>请输入球半径 4 mm，每当球压入时按空格键：共六次。</translation>
    </message>
    <message>
        <source>Calibrate with these presses and read the verdict.</source>
        <translation>请用这些按压进行标定，并阅读结论。</translation>
    </message>
    <message>
        <source>Check it with three presses, as every week.</source>
        <translation>请像每周那样，用三次按压进行检查。</translation>
    </message>
    <message>
        <source>That was a finger&apos;s whole day. Look at its contacts in 3D.</source>
        <translation>这就是手指完整的一天。请在三维视图中查看它的接触。</translation>
    </message>
</context>
<context>
    <name>alltact::UndoBar</name>
    <message>
        <source>Undo: %1</source>
        <translation>撤销：%1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>重做：%1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Z)</source>
        <translation>%1 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Shift+Z)</source>
        <translation>%1 (Ctrl+Shift+Z)</translation>
    </message>
</context>
<context>
    <name>alltact::VerdictPage</name>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>&amp;Open the report</source>
        <translation>打开报告(&amp;O)</translation>
    </message>
    <message>
        <source>Copy as command &amp;line</source>
        <translation>复制为命令行(&amp;L)</translation>
    </message>
    <message>
        <source>The same as a command line</source>
        <translation>相同操作的命令行</translation>
    </message>
    <message>
        <source>Calibrate first.</source>
        <translation>请先标定。</translation>
    </message>
    <message>
        <source>Not calibrated yet</source>
        <translation>尚未标定</translation>
    </message>
    <message>
        <source>The report is being written.</source>
        <translation>正在写报告。</translation>
    </message>
    <message>
        <source>By zone of the face: %1.</source>
        <translation>按面上的区域：%1。</translation>
    </message>
    <message>
        <source>Nothing can be said about it with these presses.</source>
        <translation>这些按压无法说明这一点。</translation>
    </message>
    <message>
        <source>press here next</source>
        <translation>下一次压这里</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>打印(&amp;P)…</translation>
    </message>
    <message>
        <source>One sheet to keep beside the finger, on paper or as PDF</source>
        <translation>一页纸，与手指放在一起，可打印或存为 PDF</translation>
    </message>
    <message>
        <source>Remarks (%1)</source>
        <translation>备注（%1）</translation>
    </message>
    <message>
        <source>With the presses as they are now there is no calibration: %1</source>
        <translation>以现在的按压无法标定：%1</translation>
    </message>
    <message>
        <source>What the presses come to now is being worked out.</source>
        <translation>正在计算现在的按压会得出什么。</translation>
    </message>
    <message>
        <source>With the presses as they are now: %1 mm, %2</source>
        <translation>以现在的按压：%1 mm，%2</translation>
    </message>
    <message>
        <source>%1 (in use: %2 mm).</source>
        <translation>%1（正在使用：%2 mm）。</translation>
    </message>
    <message>
        <source>Depth over brightness difference</source>
        <translation>深度随亮度差的变化</translation>
    </message>
    <message>
        <source>Error of every press, worst first</source>
        <translation>每次按压的误差，最差的在前</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>标定进度</translation>
    </message>
    <message>
        <source>Go to the presses</source>
        <translation>前往按压</translation>
    </message>
    <message>
        <source>Go to the check</source>
        <translation>前往检查</translation>
    </message>
    <message>
        <source>&amp;Calibrate again</source>
        <translation>重新标定(&amp;C)</translation>
    </message>
    <message>
        <source>Calibrated; how well is not stored</source>
        <translation>已标定；没有保存其质量</translation>
    </message>
    <message>
        <source>• %1</source>
        <comment>an item of a list</comment>
        <translation>• %1</translation>
    </message>
    <message numerus="yes">
        <source>• And %n more, first of the remarks.</source>
        <translation>
            <numerusform>• 另有 %n 项，列于备注之首。</numerusform>
        </translation>
    </message>
    <message>
        <source>• The presses have changed since: calibrate again.</source>
        <translation>• 此后按压已有改动：请重新标定。</translation>
    </message>
    <message>
        <source>So far ±%1 mm are to be expected.</source>
        <translation>目前预期误差为 ±%1 mm。</translation>
    </message>
    <message>
        <source>It rests on: %1.</source>
        <translation>依据：%1。</translation>
    </message>
    <message>
        <source>The presses have changed since this calibration.</source>
        <translation>此次标定之后按压已有改动。</translation>
    </message>
</context>
<context>
    <name>alltact::ViewBox</name>
    <message>
        <source>frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>the source paper&apos;s method</source>
        <translation>原论文的方法</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>显示(&amp;W)</translation>
    </message>
    <message>
        <source>Look f&amp;rom</source>
        <translation>视角(&amp;R)</translation>
    </message>
    <message>
        <source>Com&amp;pare</source>
        <translation>比较(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;With</source>
        <translation>对象(&amp;W)</translation>
    </message>
    <message>
        <source>Set&amp;ting</source>
        <translation>设置(&amp;T)</translation>
    </message>
    <message>
        <source>Frame &amp;number</source>
        <translation>帧号(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Colours end at</source>
        <translation>颜色上限(&amp;C)</translation>
    </message>
    <message>
        <source>Differe&amp;nce up to</source>
        <translation>差值上限(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Draw depth</source>
        <translation>深度放大(&amp;D)</translation>
    </message>
    <message>
        <source>Fin&amp;ger&apos;s body</source>
        <translation>手指本体(&amp;G)</translation>
    </message>
    <message>
        <source>R&amp;uler</source>
        <translation>标尺(&amp;U)</translation>
    </message>
    <message>
        <source>Ca&amp;mera</source>
        <translation>相机(&amp;M)</translation>
    </message>
    <message>
        <source>Untou&amp;ched face</source>
        <translation>未触碰的面(&amp;C)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>in 3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>as a height map</source>
        <translation>高度图</translation>
    </message>
    <message>
        <source>3D needs OpenGL 3.2, which this screen does not offer.</source>
        <translation>3D 需要 OpenGL 3.2，此屏幕不提供。</translation>
    </message>
    <message>
        <source>inside, tilted</source>
        <translation>内侧，倾斜</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>outside, tilted</source>
        <translation>外侧，倾斜</translation>
    </message>
    <message>
        <source>the side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>with nothing</source>
        <translation>不比较</translation>
    </message>
    <message>
        <source>side by side</source>
        <translation>并排</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>another setting</source>
        <translation>另一种设置</translation>
    </message>
    <message>
        <source>another frame</source>
        <translation>另一帧</translation>
    </message>
    <message>
        <source>The paper&apos;s own formulas or another setting measure the same frame of the same finger a second time; of another frame the same places of the face are compared.</source>
        <translation>用原论文的公式或另一种设置对同一手指的同一帧再测量一次；与另一帧比较时，比较面上的相同位置。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Depth at which the colours end</source>
        <translation>颜色上限对应的深度</translation>
    </message>
    <message>
        <source>Difference at which its colours end, to both sides</source>
        <translation>差值颜色的上限，正负两侧</translation>
    </message>
    <message>
        <source> times</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Times that depth is drawn larger than it is</source>
        <translation>深度按实际的多少倍绘制</translation>
    </message>
    <message>
        <source>show as %1</source>
        <translation>显示为%1</translation>
    </message>
    <message>
        <source>look from: %1</source>
        <translation>视角：%1</translation>
    </message>
    <message>
        <source>change the depth colours</source>
        <translation>更改深度的颜色</translation>
    </message>
    <message>
        <source>change the difference&apos;s colours</source>
        <translation>更改差值的颜色</translation>
    </message>
    <message>
        <source>draw depth larger</source>
        <translation>放大绘制深度</translation>
    </message>
    <message>
        <source>show %1</source>
        <translation>显示%1</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>隐藏%1</translation>
    </message>
    <message>
        <source>compare: %1</source>
        <translation>比较：%1</translation>
    </message>
    <message>
        <source>compare with %1</source>
        <translation>与%1比较</translation>
    </message>
</context>
<context>
    <name>alltact::Workspace</name>
    <message>
        <source>close the finger</source>
        <translation>关闭手指</translation>
    </message>
    <message>
        <source>open finger %1</source>
        <translation>打开手指 %1</translation>
    </message>
    <message>
        <source>close the source</source>
        <translation>关闭来源</translation>
    </message>
    <message>
        <source>open source %1</source>
        <translation>打开来源 %1</translation>
    </message>
    <message>
        <source>none</source>
        <comment>source</comment>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>alltact::WorthWords</name>
    <message>
        <source>Changed since it was calibrated</source>
        <translation>标定后已有改动</translation>
    </message>
    <message>
        <source>Broken</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>%1, ±%2 mm</source>
        <comment>a grade and the expected error</comment>
        <translation>%1，±%2 mm</translation>
    </message>
    <message>
        <source>good</source>
        <comment>an error</comment>
        <translation>好</translation>
    </message>
    <message>
        <source>fair</source>
        <comment>an error</comment>
        <translation>一般</translation>
    </message>
    <message>
        <source>poor</source>
        <comment>an error</comment>
        <translation>差</translation>
    </message>
</context>
<context>
    <name>alltact::ZeroWords</name>
    <message>
        <source>re-zero the force</source>
        <translation>力重新归零</translation>
    </message>
    <message>
        <source>show the force as measured</source>
        <translation>按测量值显示力</translation>
    </message>
</context>
<context>
    <name>alltact::en</name>
    <message>
        <source>{} x {} px is no picture size; a side must have 16 to 16384</source>
        <translation>{} x {} px 不是图片尺寸；边长必须为 16 到 16384</translation>
    </message>
    <message>
        <source>the size of the camera&apos;s pictures, [width, height]</source>
        <translation>相机图片的尺寸，[宽，高]</translation>
    </message>
    <message>
        <source>must be a number from 0.000001 to 100</source>
        <translation>必须是 0.000001 到 100 的数</translation>
    </message>
    <message>
        <source>millimetres on the object per pixel</source>
        <translation>物体上每像素的毫米数</translation>
    </message>
    <message>
        <source>must be a number from 1 to 1000000</source>
        <translation>必须是 1 到 1000000 的数</translation>
    </message>
    <message>
        <source>the focal length in pixels, as &apos;alltact lens&apos; finds it</source>
        <translation>焦距，单位像素，由 &apos;alltact lens&apos; 得出</translation>
    </message>
    <message>
        <source>must be a number from {} to {}</source>
        <translation>必须是 {} 到 {} 的数</translation>
    </message>
    <message>
        <source>the picture&apos;s centre, or run &apos;alltact lens&apos;</source>
        <translation>图片中心，或运行 &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>no</source>
        <translation>零</translation>
    </message>
    <message>
        <source>at most {}</source>
        <translation>最多 {}</translation>
    </message>
    <message>
        <source>a {} camera has {} coefficients, here are {}</source>
        <translation>{} 相机有 {} 个系数，这里有 {} 个</translation>
    </message>
    <message>
        <source>brown: k1 k2 p1 p2 k3, fisheye: k1 k2 k3 k4, others: []</source>
        <translation>brown：k1 k2 p1 p2 k3，fisheye：k1 k2 k3 k4，其他：[]</translation>
    </message>
    <message>
        <source>holds a number that no lens has</source>
        <translation>含有镜头不可能有的数</translation>
    </message>
    <message>
        <source>run &apos;alltact lens&apos;</source>
        <translation>运行 &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>belongs to a perspective camera; an orthographic one sees no nearer through it</source>
        <translation>属于透视相机；正交相机不需要它</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>去掉它</translation>
    </message>
    <message>
        <source>the distortion folds over inside the picture: near its border two directions would be seen in one pixel</source>
        <translation>畸变在画面内折叠：靠近边缘处一个像素会看到两个方向</translation>
    </message>
    <message>
        <source>run &apos;alltact lens&apos; with boards that reach into the corners, or with fewer coefficients</source>
        <translation>用到达四角的标定板或更少的系数运行 &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>{} is {} x {} px, the camera of this finger gives {} x {}</source>
        <translation>{} 为 {} x {} px，此手指的相机给出 {} x {}</translation>
    </message>
    <message>
        <source>must be a number from {:g} to {:g}</source>
        <translation>必须是 {} 到 {} 的数</translation>
    </message>
    <message>
        <source>must be a length from 0 to 1000 mm</source>
        <translation>必须是 0 到 1000 mm 的长度</translation>
    </message>
    <message>
        <source>a caliper&apos;s reading</source>
        <translation>用卡尺测量</translation>
    </message>
    <message>
        <source>must be an index of refraction from 1 to 3</source>
        <translation>必须是 1 到 3 的折射率</translation>
    </message>
    <message>
        <source>1 for air, 1.33 water, 1.41 silicone, 1.49 acrylic, 1.52 glass</source>
        <translation>空气 1，水 1.33，硅胶 1.41，亚克力 1.49，玻璃 1.52</translation>
    </message>
    <message>
        <source>{} or {}</source>
        <translation>{} 或 {}</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>以下之一：{}</translation>
    </message>
    <message>
        <source>&apos;{}&apos;, or else {}</source>
        <translation>“{}”，或者{}</translation>
    </message>
    <message>
        <source>must be two whole numbers</source>
        <translation>必须是两个整数</translation>
    </message>
    <message>
        <source>[width, height] in pixels</source>
        <translation>[宽，高]，单位像素</translation>
    </message>
    <message>
        <source>the air between lens and window in mm</source>
        <translation>镜头与窗口之间的空气，单位 mm</translation>
    </message>
    <message>
        <source>the window&apos;s thickness in mm</source>
        <translation>窗口的厚度，单位 mm</translation>
    </message>
    <message>
        <source>the window&apos;s index of refraction</source>
        <translation>窗口的折射率</translation>
    </message>
    <message>
        <source>the index of what lies behind it</source>
        <translation>窗口后面介质的折射率</translation>
    </message>
    <message>
        <source>the size of a pixel in mm</source>
        <translation>像素的大小，单位 mm</translation>
    </message>
    <message>
        <source>the focal length in pixels</source>
        <translation>焦距，单位像素</translation>
    </message>
    <message>
        <source>the principal point in pixels</source>
        <translation>主点，单位像素</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>缺少数字</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number</source>
        <translation>“{}”不是数字</translation>
    </message>
    <message>
        <source>&apos;{}&apos; holds a mark between thousands: write {}</source>
        <translation>“{}”含有千位分隔符：请写成 {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has &apos;{}&apos; behind the number: leave that out</source>
        <translation>“{}”在数字后面有“{}”：请去掉</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is in &apos;{}&apos;: give the number in {}</source>
        <translation>“{}”的单位是“{}”：请以 {} 为单位输入</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is too large or too small a number</source>
        <translation>“{}”这个数字太大或太小</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; can mean {1} or {2}: write {1} or {2}</source>
        <translation>“{0}”可能是 {1} 或 {2}：请写成 {1} 或 {2}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has too many digits behind the decimal mark (at most {})</source>
        <translation>“{}”的小数位太多（最多 {} 位）</translation>
    </message>
    <message>
        <source>a comma parts the entries here, and &apos;{}&apos; is none</source>
        <translation>此处逗号用于分隔各项，而“{}”不是一项</translation>
    </message>
    <message>
        <source>must be a number from {:g} to {:g} {}</source>
        <translation>必须是 {} 到 {} {} 之间的数字</translation>
    </message>
    <message>
        <source>must be a number from {:g} to {:g}{}</source>
        <translation>必须是 {} 到 {}{} 之间的数字</translation>
    </message>
    <message>
        <source>must be a whole number from {} to {}</source>
        <translation>必须是 {} 到 {} 之间的整数</translation>
    </message>
    <message>
        <source>{:g} {} is more than usual for {} ({:g} to {:g} {}): check the decimal mark</source>
        <translation>{} {} 大于{}的常见范围（{} 到 {} {}）：请检查小数点</translation>
    </message>
    <message>
        <source>{:g} {} is less than usual for {} ({:g} to {:g} {}): check the decimal mark</source>
        <translation>{} {} 小于{}的常见范围（{} 到 {} {}）：请检查小数点</translation>
    </message>
    <message>
        <source>{:g} px is unusual ({:g} to {:g} px): check the decimal mark</source>
        <translation>{} px 不常见（{} 到 {} px）：请检查小数点</translation>
    </message>
    <message>
        <source>the radius of a ball</source>
        <translation>球的半径</translation>
    </message>
    <message>
        <source>the width of a face</source>
        <translation>面的宽度</translation>
    </message>
    <message>
        <source>the thickness of a layer</source>
        <translation>层的厚度</translation>
    </message>
    <message>
        <source>the distance of a flat face</source>
        <translation>平面的距离</translation>
    </message>
    <message>
        <source>the depth of a press</source>
        <translation>按压的深度</translation>
    </message>
    <message>
        <source>how well a depth is known</source>
        <translation>深度的不确定度</translation>
    </message>
    <message>
        <source>the step of a punch</source>
        <translation>压头的台阶</translation>
    </message>
    <message>
        <source>the side of a square</source>
        <translation>方格的边长</translation>
    </message>
    <message>
        <source>a length on a finger</source>
        <translation>手指上的长度</translation>
    </message>
    <message>
        <source>the thickness of the translucent layer in mm, for example 1.5</source>
        <translation>半透明层的厚度，单位 mm，例如 1.5</translation>
    </message>
    <message>
        <source>the distance between the two edges of the view face in mm</source>
        <translation>面的两条边缘之间的距离，单位 mm</translation>
    </message>
    <message>
        <source>a fin_ray needs a camera with perspective: its shape comes from it</source>
        <translation>fin_ray 需要透视相机：形状由它得出</translation>
    </message>
    <message>
        <source>pinhole, brown or fisheye</source>
        <translation>pinhole、brown 或 fisheye</translation>
    </message>
    <message>
        <source>must be above 0 and at most 10000: the face lies before the camera</source>
        <translation>必须大于 0 且不超过 10000：面在相机前方</translation>
    </message>
    <message>
        <source>must be a number from -10000 to 10000</source>
        <translation>必须是 -10000 到 10000 的数</translation>
    </message>
    <message>
        <source>the distance of the face from the camera in mm</source>
        <translation>面到相机的距离，单位 mm</translation>
    </message>
    <message>
        <source>a flat sensor has no markers</source>
        <translation>平面传感器没有标记点</translation>
    </message>
    <message>
        <source>remove the block &apos;markers&apos;</source>
        <translation>删除 &apos;markers&apos; 段</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to 64</source>
        <translation>必须是 0 到 64 的整数</translation>
    </message>
    <message>
        <source>the number of dots on one side face, 0 for a finger without</source>
        <translation>一个侧面上标记点的个数，没有标记点则为 0</translation>
    </message>
    <message>
        <source>must be numbers from 0 to {}, ascending</source>
        <translation>必须是 0 到 {} 的编号，按升序排列</translation>
    </message>
    <message>
        <source>record the reference again</source>
        <translation>重新录制参考</translation>
    </message>
    <message>
        <source>calibrate again</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>gives depths up to {:.3g} mm in a layer of {:g} mm</source>
        <translation>给出的深度达 {} mm，而层厚只有 {} mm</translation>
    </message>
    <message>
        <source>must be a number from 0 to 1000</source>
        <translation>必须是 0 到 1000 的数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no file inside the finger&apos;s folder</source>
        <translation>“{}”不是手指文件夹内的文件</translation>
    </message>
    <message>
        <source>copy the file into the folder and give its name only</source>
        <translation>把文件复制到文件夹中，只写文件名</translation>
    </message>
    <message>
        <source>must be a column of the picture and a step of 0.001 to 500 mm</source>
        <translation>必须是图像的一列和 0.001 到 500 mm 的步长</translation>
    </message>
    <message>
        <source>there is either a video with its markers or one picture, not both</source>
        <translation>要么是带标记点的视频，要么是一张图片，不能两者都有</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>删除其中之一</translation>
    </message>
    <message>
        <source>must be above 0 and at most 1000000</source>
        <translation>必须大于 0 且不超过 1000000</translation>
    </message>
    <message>
        <source>holds {} positions, but there are {} markers</source>
        <translation>含有 {} 个位置，但有 {} 个标记点</translation>
    </message>
    <message>
        <source>holds a position far outside the picture</source>
        <translation>含有远在图片之外的位置</translation>
    </message>
    <message>
        <source>must be three numbers from -10000 to 10000</source>
        <translation>必须是三个从 -10000 到 10000 的数</translation>
    </message>
    <message>
        <source>where the camera sits in the gripper, in mm</source>
        <translation>相机在夹爪中的位置，单位 mm</translation>
    </message>
    <message>
        <source>is no rotation: a quaternion w, x, y, z has the length 1</source>
        <translation>不是旋转：四元数 w, x, y, z 的长度为 1</translation>
    </message>
    <message>
        <source>[1.0, 0.0, 0.0, 0.0] for a camera that is not turned</source>
        <translation>相机没有转动时用 [1.0, 0.0, 0.0, 0.0]</translation>
    </message>
    <message>
        <source>must be a text of 1 to 200 letters</source>
        <translation>必须是 1 到 200 个字符的文本</translation>
    </message>
    <message>
        <source>what is written on the finger</source>
        <translation>写在手指上的名字</translation>
    </message>
    <message>
        <source>says how a mapping was made, but there is none</source>
        <translation>记录了映射的来源，但没有映射</translation>
    </message>
    <message>
        <source>calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>a length in mm</source>
        <translation>长度，单位 mm</translation>
    </message>
    <message>
        <source>a distance in mm</source>
        <translation>距离，单位 mm</translation>
    </message>
    <message>
        <source>must be a list of whole numbers</source>
        <translation>必须是整数列表</translation>
    </message>
    <message>
        <source>[3, 9]</source>
        <translation>[3, 9]</translation>
    </message>
    <message>
        <source>must have as many numbers in each row as there are rows</source>
        <translation>每行的数字个数必须等于行数</translation>
    </message>
    <message>
        <source>is not the curve that &apos;chebyshev&apos; gives</source>
        <translation>不是 &apos;chebyshev&apos; 给出的曲线</translation>
    </message>
    <message>
        <source>remove this line: it is only for people to read</source>
        <translation>删除此行：它只供人阅读</translation>
    </message>
    <message>
        <source>a part of the depth</source>
        <translation>深度的一部分</translation>
    </message>
    <message>
        <source>must be two numbers: mm along and across the face</source>
        <translation>必须是两个数：沿面和横向的 mm</translation>
    </message>
    <message>
        <source>must be two numbers, the first of them 0</source>
        <translation>必须是两个数，第一个为 0</translation>
    </message>
    <message>
        <source>for example [0.0, 0.62]</source>
        <translation>例如 [0.0, 0.62]</translation>
    </message>
    <message>
        <source>a depth in mm</source>
        <translation>深度，单位 mm</translation>
    </message>
    <message>
        <source>without unit</source>
        <translation>无单位</translation>
    </message>
    <message>
        <source>in mm</source>
        <translation>单位 mm</translation>
    </message>
    <message>
        <source>must be two numbers: a column in px, a step in mm</source>
        <translation>必须是两个数：以 px 计的列和以 mm 计的步长</translation>
    </message>
    <message>
        <source>a sum of offsets in pixels</source>
        <translation>位移之和，单位像素</translation>
    </message>
    <message>
        <source>must hold two numbers for each marker</source>
        <translation>每个标记点必须有两个数</translation>
    </message>
    <message>
        <source>[[u, v], ...]</source>
        <translation>[[u, v], ...]</translation>
    </message>
    <message>
        <source>must be three numbers: x, y, z in mm</source>
        <translation>必须是三个数：x、y、z，单位 mm</translation>
    </message>
    <message>
        <source>must be four numbers: w, x, y, z of a unit quaternion</source>
        <translation>必须是四个数：单位四元数的 w、x、y、z</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be read by this version</source>
        <translation>此版本无法读取“{}”</translation>
    </message>
    <message>
        <source>a newer version of this program, or &apos;{}&apos;</source>
        <translation>使用更新的程序版本，或“{}”</translation>
    </message>
    <message>
        <source>must name a file</source>
        <translation>必须给出文件名</translation>
    </message>
    <message>
        <source>force.yaml</source>
        <translation>force.yaml</translation>
    </message>
    <message>
        <source>leave it out, or calibrate again</source>
        <translation>去掉它，或重新标定</translation>
    </message>
    <message>
        <source>must be {0} rows of {0} numbers</source>
        <translation>必须是 {0} 行，每行 {0} 个数</translation>
    </message>
    <message>
        <source>holds values that no covariance has</source>
        <translation>含有协方差不可能有的值</translation>
    </message>
    <message>
        <source>has a negative variance</source>
        <translation>有负的方差</translation>
    </message>
    <message>
        <source>is not symmetric</source>
        <translation>不对称</translation>
    </message>
    <message>
        <source>must hold finite numbers, half_mm above 0, along and across together at most 0.5</source>
        <translation>必须是有限数，half_mm 大于 0，along 与 across 之和不超过 0.5</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>必须是正数</translation>
    </message>
    <message>
        <source>must be greater than {:.6g}, where the curve has its pole, and at most 1000000</source>
        <translation>必须大于 {}（曲线的极点处）且不超过 1000000</translation>
    </message>
    <message>
        <source>must hold 1 to {} numbers</source>
        <translation>必须含有 1 到 {} 个数</translation>
    </message>
    <message>
        <source>holds a number that is no coefficient in mm</source>
        <translation>含有不是系数（mm）的数</translation>
    </message>
    <message>
        <source>must end above 0 and at 1 or below: it is a relative difference of brightness</source>
        <translation>终点必须大于 0 且不超过 1：这是相对亮度差</translation>
    </message>
    <message>
        <source>the curve does not rise at x = {:.4g} (slope {:.4g} mm)</source>
        <translation>曲线在 x = {} 处不上升（斜率 {} mm）</translation>
    </message>
    <message>
        <source>calibrate with fewer coefficients or as moebius, or with deeper presses</source>
        <translation>用更少的系数或 moebius 标定，或按得更深</translation>
    </message>
    <message>
        <source>gives a depth of {:.4g} mm at the end of its domain; it must lie above 0 and below {:g} mm</source>
        <translation>在定义域终点给出深度 {} mm；必须大于 0 且小于 {} mm</translation>
    </message>
    <message>
        <source>there is a finger already, and it is never overwritten</source>
        <translation>已有一个手指，不会覆盖它</translation>
    </message>
    <message>
        <source>another folder, or moving that one away</source>
        <translation>换一个文件夹，或将其移走</translation>
    </message>
    <message>
        <source>could not write the file</source>
        <translation>无法写入文件</translation>
    </message>
    <message>
        <source>could not make sure that the folder is on the disk</source>
        <translation>无法确认文件夹已写到磁盘</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>其文件夹不存在</translation>
    </message>
    <message>
        <source>make the folder first, or check the path for typing errors</source>
        <translation>先建立文件夹，或检查路径是否输错</translation>
    </message>
    <message>
        <source>could not read the file</source>
        <translation>无法读取文件</translation>
    </message>
    <message>
        <source>it is larger than {} bytes</source>
        <translation>它大于 {} 字节</translation>
    </message>
    <message>
        <source>check that it is the right file</source>
        <translation>检查文件是否正确</translation>
    </message>
    <message>
        <source>could not make the folder</source>
        <translation>无法建立文件夹</translation>
    </message>
    <message>
        <source>a shorter USB cable or another port; if it stays, another format or a lower rate</source>
        <translation>换短一些的 USB 线或另一接口；若仍如此，换一种格式或降低帧率</translation>
    </message>
    <message>
        <source>a picture came with {} of {} bytes</source>
        <translation>收到的图像只有 {} / {} 字节</translation>
    </message>
    <message>
        <source>a picture came that is no JPEG</source>
        <translation>收到的图像不是 JPEG</translation>
    </message>
    <message>
        <source>a picture of {}x{} came where {}x{} was agreed</source>
        <translation>收到 {}x{} 的图像，而约定为 {}x{}</translation>
    </message>
    <message>
        <source>a JPEG came that is truncated or damaged</source>
        <translation>收到的 JPEG 不完整或已损坏</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>另一个程序</translation>
    </message>
    <message>
        <source>somebody else is at work here: {0}</source>
        <translation>这里已有其他程序在工作：{0}</translation>
    </message>
    <message>
        <source>waiting until that is done</source>
        <translation>等待其完成</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>无法写入</translation>
    </message>
    <message>
        <source>could not be held</source>
        <translation>无法占用</translation>
    </message>
    <message>
        <source>the picture says it is {} x {} px; a side must have 1 to {}</source>
        <translation>图片标称 {} x {} px；边长必须为 1 到 {}</translation>
    </message>
    <message>
        <source>a smaller picture, or copy it again if that size is wrong</source>
        <translation>使用更小的图片；若尺寸有误请重新复制</translation>
    </message>
    <message>
        <source>the picture is damaged or cut short</source>
        <translation>图片已损坏或不完整</translation>
    </message>
    <message>
        <source>copy or record it again</source>
        <translation>重新复制或录制</translation>
    </message>
    <message>
        <source>the picture has {} bits per channel (floating point); 8 are needed</source>
        <translation>图片每通道 {} 位（浮点）；需要 8 位</translation>
    </message>
    <message>
        <source>the picture has {} bits per channel; 8 are needed</source>
        <translation>图片每通道 {} 位；需要 8 位</translation>
    </message>
    <message>
        <source>the camera&apos;s 8-bit pictures</source>
        <translation>使用相机的 8 位图片</translation>
    </message>
    <message>
        <source>the picture has transparent parts; a camera takes none</source>
        <translation>图片有透明部分；相机不会拍出这种图片</translation>
    </message>
    <message>
        <source>the picture as the camera took it, without an alpha channel</source>
        <translation>使用相机原图，不带 alpha 通道</translation>
    </message>
    <message>
        <source>the picture has {} channels; 1 or 3 are needed</source>
        <translation>图片有 {} 个通道；需要 1 或 3 个</translation>
    </message>
    <message>
        <source>the picture as the camera took it</source>
        <translation>使用相机原图</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>cannot write this kind of picture ({}) under that name</source>
        <translation>不能用这个名字写出这种图片（{}）</translation>
    </message>
    <message>
        <source>&apos;.png&apos; for 8-bit pictures, &apos;.tiff&apos; for floating point</source>
        <translation>8 位图片用 &apos;.png&apos;，浮点用 &apos;.tiff&apos;</translation>
    </message>
    <message>
        <source>could not encode the picture</source>
        <translation>无法编码图片</translation>
    </message>
    <message>
        <source>a smaller picture</source>
        <translation>使用更小的图片</translation>
    </message>
    <message>
        <source>the picture is of a kind that cannot be used ({})</source>
        <translation>图片的种类不可用（{}）</translation>
    </message>
    <message>
        <source>8-bit grey pictures</source>
        <translation>使用 8 位灰度图</translation>
    </message>
    <message>
        <source>the picture is in colour: its channels differ from grey by {:.0f} %</source>
        <translation>图片是彩色的：各通道偏离灰色 {} %</translation>
    </message>
    <message>
        <source>a picture of the finger under white light</source>
        <translation>使用白光下的手指图片</translation>
    </message>
    <message>
        <source>the picture is all black</source>
        <translation>图片全黑</translation>
    </message>
    <message>
        <source>switch on the light, or take off the lens cap</source>
        <translation>打开灯，或取下镜头盖</translation>
    </message>
    <message>
        <source>the picture is no TIFF of 32-bit floating point with 1 or 3 channels</source>
        <translation>图片不是 1 或 3 通道的 32 位浮点 TIFF</translation>
    </message>
    <message>
        <source>a depth or points picture written by this program</source>
        <translation>使用本程序写出的深度图或点图</translation>
    </message>
    <message>
        <source>the picture is cut short</source>
        <translation>图片不完整</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>图片已损坏</translation>
    </message>
    <message>
        <source>it does not begin with its header</source>
        <translation>开头不是文件头</translation>
    </message>
    <message>
        <source>a check sum is wrong</source>
        <translation>校验和不对</translation>
    </message>
    <message>
        <source>its parts do not join</source>
        <translation>各部分接不上</translation>
    </message>
    <message>
        <source>it has no header</source>
        <translation>没有文件头</translation>
    </message>
    <message>
        <source>its header is of a kind no longer in use</source>
        <translation>文件头是已不再使用的种类</translation>
    </message>
    <message>
        <source>its width is negative</source>
        <translation>宽度为负</translation>
    </message>
    <message>
        <source>its header holds something that is no number</source>
        <translation>文件头中有不是数字的内容</translation>
    </message>
    <message>
        <source>its white is not 255</source>
        <translation>白色不是 255</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件是空的</translation>
    </message>
    <message>
        <source>the file is no picture of a kind that is known here</source>
        <translation>文件不是这里认识的图片</translation>
    </message>
    <message>
        <source>PNG, JPEG, BMP, binary PGM or TIFF</source>
        <translation>PNG、JPEG、BMP、二进制 PGM 或 TIFF</translation>
    </message>
    <message>
        <source>no surface can be written under such a name</source>
        <translation>不能用这样的名字写出表面</translation>
    </message>
    <message>
        <source>a name that ends in .ply, .vtp, .stl or .glb</source>
        <translation>以 .ply、.vtp、.stl 或 .glb 结尾的名字</translation>
    </message>
    <message>
        <source>there is no point of the face to write</source>
        <translation>没有可写出的面上的点</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>free some space, or choose a folder on another disk</source>
        <translation>腾出空间，或选择另一磁盘上的文件夹</translation>
    </message>
    <message>
        <source>your share of the disk is used up</source>
        <translation>您的磁盘配额已用完</translation>
    </message>
    <message>
        <source>free some space, or choose another disk</source>
        <translation>腾出空间，或选择另一磁盘</translation>
    </message>
    <message>
        <source>the file would be larger than this system allows</source>
        <translation>文件会超过系统允许的大小</translation>
    </message>
    <message>
        <source>another disk</source>
        <translation>换一个磁盘</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>磁盘是只读的</translation>
    </message>
    <message>
        <source>a folder on a disk that can be written to</source>
        <translation>选择可写磁盘上的文件夹</translation>
    </message>
    <message>
        <source>access is not allowed</source>
        <translation>没有访问权限</translation>
    </message>
    <message>
        <source>another folder, or ask its owner for access</source>
        <translation>换一个文件夹，或向其所有者申请权限</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>不存在</translation>
    </message>
    <message>
        <source>check the path for typing errors</source>
        <translation>检查路径是否输错</translation>
    </message>
    <message>
        <source>a part of the path is no folder</source>
        <translation>路径的一部分不是文件夹</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>这是文件夹</translation>
    </message>
    <message>
        <source>name a file inside it</source>
        <translation>指定其中的文件</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>名字太长</translation>
    </message>
    <message>
        <source>a shorter name</source>
        <translation>使用更短的名字</translation>
    </message>
    <message>
        <source>the disk reports a fault</source>
        <translation>磁盘报告故障</translation>
    </message>
    <message>
        <source>another disk, and look after this one</source>
        <translation>换一个磁盘，并检查这个磁盘</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>打开的文件太多</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>关闭其他程序</translation>
    </message>
    <message>
        <source>once more, or another folder</source>
        <translation>再试一次，或换一个文件夹</translation>
    </message>
    <message>
        <source>could not write the archive</source>
        <translation>无法写入压缩包</translation>
    </message>
    <message>
        <source>another name for the file that is meant</source>
        <translation>给该文件换一个名字</translation>
    </message>
    <message>
        <source>packing {}</source>
        <translation>正在打包 {}</translation>
    </message>
    <message>
        <source>stopped before it was packed</source>
        <translation>打包完成前已停止</translation>
    </message>
    <message>
        <source>{}, {}</source>
        <translation>{}，{}</translation>
    </message>
    <message>
        <source>{}; {}</source>
        <translation>{};{}</translation>
    </message>
    <message>
        <source>{}. {}</source>
        <translation>{}。{}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>this file that comes with the program is not there</source>
        <translation>缺少随程序安装的这个文件</translation>
    </message>
    <message>
        <source>installing the program again</source>
        <translation>重新安装程序</translation>
    </message>
    <message>
        <source>could not write the recording&apos;s journal</source>
        <translation>无法写入录像日志</translation>
    </message>
    <message>
        <source>frame {} is older than frame {}</source>
        <translation>第 {} 帧比第 {} 帧更早</translation>
    </message>
    <message>
        <source>move this file away: the video&apos;s own times count then</source>
        <translation>移走这个文件：之后使用视频自身的时间</translation>
    </message>
    <message>
        <source>play it in a video player; if that fails too, record it again</source>
        <translation>用视频播放器播放；若也不行，请重新录制</translation>
    </message>
    <message>
        <source>once more</source>
        <translation>再试一次</translation>
    </message>
    <message>
        <source>the video cannot be opened</source>
        <translation>无法打开视频</translation>
    </message>
    <message>
        <source>its kind of picture has no brightness</source>
        <translation>其图像种类没有亮度</translation>
    </message>
    <message>
        <source>a grey or colour video</source>
        <translation>使用灰度或彩色视频</translation>
    </message>
    <message>
        <source>could not write the video</source>
        <translation>无法写入视频</translation>
    </message>
    <message>
        <source>it is being recorded or mended right now</source>
        <translation>它正在被录制或修复</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>换一个名字</translation>
    </message>
    <message>
        <source>this is no Matroska file</source>
        <translation>这不是 Matroska 文件</translation>
    </message>
    <message>
        <source>stopped before it was mended</source>
        <translation>修复完成前已停止</translation>
    </message>
    <message>
        <source>mending an interrupted recording</source>
        <translation>正在修复中断的录像</translation>
    </message>
    <message>
        <source>only {} of its {} frames could be read</source>
        <translation>{1} 帧中只能读取 {0} 帧</translation>
    </message>
    <message>
        <source>another copy of the recording</source>
        <translation>使用录像的另一份副本</translation>
    </message>
    <message>
        <source>the interrupted recording cannot be mended</source>
        <translation>无法修复中断的录像</translation>
    </message>
    <message>
        <source>wait for its end</source>
        <translation>等它结束</translation>
    </message>
    <message>
        <source>could not put the recording back</source>
        <translation>无法放回录像</translation>
    </message>
    <message>
        <source>stopped when {} of {} MB of the recording were put back</source>
        <translation>放回录像 {} / {} MB 时已停止</translation>
    </message>
    <message>
        <source>putting the removed recording back: {} of {} MB</source>
        <translation>正在放回被删除的录像：{} / {} MB</translation>
    </message>
    <message>
        <source>the disk is nearly full: {} MB are left, {} MB are kept free</source>
        <translation>磁盘将满：剩余 {} MB，保留 {} MB</translation>
    </message>
    <message>
        <source>free some space, or record to another disk</source>
        <translation>腾出空间，或录制到另一磁盘</translation>
    </message>
    <message>
        <source>there is a file already</source>
        <translation>已有同名文件</translation>
    </message>
    <message>
        <source>another name, or remove the old one</source>
        <translation>换一个名字，或删除旧文件</translation>
    </message>
    <message>
        <source>could not begin the recording: its folder does not exist</source>
        <translation>无法开始录制：文件夹不存在</translation>
    </message>
    <message>
        <source>could not begin the recording</source>
        <translation>无法开始录制</translation>
    </message>
    <message>
        <source>how pictures are stored, all without loss: auto takes the camera&apos;s own packets (mjpeg) where it sends such, else magicyuv; ffv1 is about a tenth smaller and four times slower to read</source>
        <translation>图片如何存储，均为无损：auto 在相机送出数据包（mjpeg）时直接采用，否则用 magicyuv；ffv1 约小十分之一，但读取慢四倍</translation>
    </message>
    <message>
        <source>memory for frames that wait for the disk, in megabytes</source>
        <translation>等待写盘的帧所用内存，单位 MB</translation>
    </message>
    <message>
        <source>space that is left free on the disk, in megabytes; the recording ends before</source>
        <translation>磁盘上保留的空间，单位 MB；录制会在此之前结束</translation>
    </message>
    <message>
        <source>the recording was removed while it was being made</source>
        <translation>录制过程中录像被删除</translation>
    </message>
    <message>
        <source>no frame came, so nothing was recorded</source>
        <translation>没有收到帧，因此没有录制</translation>
    </message>
    <message>
        <source>check the source</source>
        <translation>检查来源</translation>
    </message>
    <message>
        <source>the recording was removed at its end</source>
        <translation>录制结束时录像被删除</translation>
    </message>
    <message>
        <source>{}, and it could not be put back ({})</source>
        <translation>{}，而且无法放回（{}）</translation>
    </message>
    <message>
        <source>record again, and leave the folder alone meanwhile</source>
        <translation>重新录制，期间不要动该文件夹</translation>
    </message>
    <message>
        <source>what was recorded until then was put back</source>
        <translation>到那时为止录制的内容已放回</translation>
    </message>
    <message>
        <source>leave the folder alone while it records</source>
        <translation>录制期间不要动该文件夹</translation>
    </message>
    <message>
        <source>recordings are Matroska files</source>
        <translation>录像是 Matroska 文件</translation>
    </message>
    <message>
        <source>a name that ends in .mkv</source>
        <translation>以 .mkv 结尾的名字</translation>
    </message>
    <message>
        <source>the video cannot be opened: no decoder for {}</source>
        <translation>无法打开视频：没有 {} 的解码器</translation>
    </message>
    <message>
        <source>frame {} of the video cannot be read</source>
        <translation>无法读取视频的第 {} 帧</translation>
    </message>
    <message>
        <source>the video holds no frame</source>
        <translation>视频中没有帧</translation>
    </message>
    <message>
        <source>this system&apos;s libavcodec cannot write {}</source>
        <translation>本系统的 libavcodec 不能写 {}</translation>
    </message>
    <message>
        <source>another codec, or Debian&apos;s libavcodec</source>
        <translation>换一种编码，或使用 Debian 的 libavcodec</translation>
    </message>
    <message>
        <source>only 8-bit grey pictures can be recorded</source>
        <translation>只能录制 8 位灰度图</translation>
    </message>
    <message>
        <source>a grey source</source>
        <translation>使用灰度来源</translation>
    </message>
    <message>
        <source>the picture is {} x {}, those before were {} x {}</source>
        <translation>图片为 {} x {}，之前的为 {} x {}</translation>
    </message>
    <message>
        <source>one recording for each size</source>
        <translation>每种尺寸单独录制</translation>
    </message>
    <message>
        <source>the source gives no JPEG packets that could be stored untouched</source>
        <translation>来源没有可原样存储的 JPEG 数据包</translation>
    </message>
    <message>
        <source>the codec magicyuv or ffv1</source>
        <translation>使用 magicyuv 或 ffv1 编码</translation>
    </message>
    <message>
        <source>{}. Try: {}</source>
        <translation>{}。建议：{}</translation>
    </message>
    <message>
        <source>the two long edges of the face were not found</source>
        <translation>没有找到面的两条长边</translation>
    </message>
    <message>
        <source>the picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>light the finger as in its recording, and check that the picture shows the face from base to tip with the finger&apos;s length along the picture&apos;s width</source>
        <translation>按录制时的方式照亮手指，并检查图片是否显示从根部到指尖的面，手指长度方向沿图片宽度</translation>
    </message>
    <message>
        <source>the face&apos;s edges</source>
        <translation>面的边缘</translation>
    </message>
    <message>
        <source>a picture in which both long edges of the bright face are visible and lit evenly; check that the lamps are on and that the lens is clean</source>
        <translation>能看见明亮面两条长边且光照均匀的图片；检查灯是否打开、镜头是否干净</translation>
    </message>
    <message>
        <source>the shape of a Fin Ray needs a perspective camera, not an orthographic one</source>
        <translation>Fin Ray 的形状需要透视相机，不能用正交相机</translation>
    </message>
    <message>
        <source>no smooth shape fits the outline of the face: it jumps at column {:.0f}</source>
        <translation>没有平滑的形状与接触面的轮廓相符：轮廓在第 {} 列处跳变</translation>
    </message>
    <message>
        <source>bending the finger less, until no part of it hides another</source>
        <translation>让手指弯得少一些，直到没有一部分遮住另一部分</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>上</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>下</translation>
    </message>
    <message>
        <source>the {} edge of the face was seen in too few columns</source>
        <translation>面的{}边缘只在太少的列中可见</translation>
    </message>
    <message>
        <source>the two edges were never seen together</source>
        <translation>两条边缘从未同时可见</translation>
    </message>
    <message>
        <source>no smooth shape fits them</source>
        <translation>没有平滑的形状与之相符</translation>
    </message>
    <message>
        <source>the distance of the face is too uncertain in every column</source>
        <translation>面的距离在每一列都太不确定</translation>
    </message>
    <message>
        <source>the picture is black: its brightest parts reach {} of 255 grey levels; take the cap off the lens, switch the lamps on, or expose longer</source>
        <translation>画面全黑：最亮处只有 255 级灰度中的 {}；请取下镜头盖、打开灯或延长曝光</translation>
    </message>
    <message>
        <source>the picture is too bright: {:.0f} % of it is saturated; expose shorter, or dim the lamps</source>
        <translation>画面过亮：{} % 已饱和；请缩短曝光或调暗灯光</translation>
    </message>
    <message>
        <source>the picture is blank: all of it has {} of 255 grey levels, without even a camera&apos;s noise; plug the camera in again</source>
        <translation>画面空白：处处都是 255 级灰度中的 {}，连相机噪声都没有；请重新插拔相机</translation>
    </message>
    <message>
        <source>{:.0f} % of the face is too bright to be measured; expose shorter, or dim the lamps</source>
        <translation>接触面的 {} % 过亮，无法测量；请缩短曝光或调暗灯光</translation>
    </message>
    <message>
        <source>{:.0f} % of the face was never recorded in a pose like this; record the finger bending further in this direction</source>
        <translation>接触面的 {} % 在这样的姿态下没有录制过；请录制手指向此方向弯得更多的情形</translation>
    </message>
    <message>
        <source>{:.1f} % of the face, at its end, is hidden in this frame: nothing is told of it, neither that it is touched nor that it is not</source>
        <translation>接触面末端有 {} % 在此图像中被遮挡：对该部分不作任何判断，既不说被触碰，也不说未被触碰</translation>
    </message>
    <message>
        <source>the face is {:.0f} % darker than when its reference was recorded; set exposure, gain and lamps as they were then</source>
        <translation>接触面比录制参考时暗 {} %；请把曝光、增益和灯光设回当时的值</translation>
    </message>
    <message>
        <source>the face is {:.0f} % brighter than when its reference was recorded; set exposure, gain and lamps as they were then</source>
        <translation>接触面比录制参考时亮 {} %；请把曝光、增益和灯光设回当时的值</translation>
    </message>
    <message>
        <source>{:.0f} % of the face is brighter than its reference: this is another finger, or its skin has changed; choose the finger that it is, or record the reference again</source>
        <translation>接触面的 {} % 比其参考更亮：这是另一根手指，或其表皮已改变；请选择对应的手指，或重新录制参考</translation>
    </message>
    <message>
        <source>only {} recorded pictures show every marker; at least 2 are needed</source>
        <translation>只有 {} 张录制的图片显示全部标记点；至少需要 2 张</translation>
    </message>
    <message>
        <source>marker model</source>
        <translation>标记点模型</translation>
    </message>
    <message>
        <source>record the finger bending with both side faces in view and evenly lit</source>
        <translation>录制手指弯曲的过程，两个侧面都在画面内且光照均匀</translation>
    </message>
    <message>
        <source>{} markers have a position but {} have a size</source>
        <translation>{} 个标记点有位置，但有 {} 个有大小</translation>
    </message>
    <message>
        <source>the markers&apos; positions are not finite numbers</source>
        <translation>标记点的位置不是有限数</translation>
    </message>
    <message>
        <source>{} dots were found beside the face, but no third of the {} markers among them fits a pose of the reference recording</source>
        <translation>在面旁找到 {} 个点，但其中没有三分之一的标记点（共 {} 个）与参考录像的任何姿态相符</translation>
    </message>
    <message>
        <source>this pose was never recorded: the nearest reference frame is {:.1f} px away; record the finger bending further in this direction</source>
        <translation>这个姿态没有录制过：最近的参考帧相距 {} px；请录制手指向此方向弯得更多的情形</translation>
    </message>
    <message>
        <source>a picture at the size that the finger was calibrated with</source>
        <translation>使用与标定时尺寸相同的图片</translation>
    </message>
    <message>
        <source>the picture is the same as the one before to the last grey level: the camera stands still; plug it in again</source>
        <translation>画面与上一帧逐级灰度完全相同：相机已停住；请重新插拔相机</translation>
    </message>
    <message>
        <source>{}.</source>
        <translation>{}。</translation>
    </message>
    <message>
        <source>too little of the face is seen to tell the pose by its shape</source>
        <translation>可见的面太少，无法由其形状判断姿态</translation>
    </message>
    <message>
        <source>the markers were not found: the face&apos;s shape alone tells this pose, so that depth is less sure and neither twist nor what touches the finger is told; uncover and light the dots on the side faces</source>
        <translation>未找到标记点：只能由接触面的形状判断该姿态，因此深度不太可靠，也无法给出扭转以及手指被什么触碰；请露出并照亮侧面上的圆点</translation>
    </message>
    <message>
        <source>few recorded frames are near this pose: its reference is {:.0f} times less sure than usual; record the finger bending slowly through it</source>
        <translation>此姿态附近录制的帧很少：其参考的不确定度是通常的 {} 倍；请录制手指缓慢弯过此姿态的情形</translation>
    </message>
    <message>
        <source>the finger is not calibrated: calibrate it with ball presses</source>
        <translation>手指尚未标定：请用球按压标定</translation>
    </message>
    <message>
        <source>how the face&apos;s edges are placed: half-way crossing to a fiftieth of a pixel, or the steepest whole pixel</source>
        <translation>面的边缘如何定位：半高处，精度五十分之一像素，或最陡的整像素</translation>
    </message>
    <message>
        <source>pixel columns averaged into one place on each edge</source>
        <translation>每条边缘上合并为一个位置的像素列数</translation>
    </message>
    <message>
        <source>degree of the smooth curve through each edge of the face</source>
        <translation>通过面每条边缘的平滑曲线的次数</translation>
    </message>
    <message>
        <source>whether a change of the light since the reference is read from the untouched skin and taken out</source>
        <translation>是否由未触碰的表皮读出参考之后的光照变化并扣除</translation>
    </message>
    <message>
        <source>standard deviation of the smoothing before depth is read, in pixels; 0: none</source>
        <translation>读取深度前平滑的标准差，单位像素；0：不平滑</translation>
    </message>
    <message>
        <source>depth that counts as touched, in millimetres</source>
        <translation>算作触碰的深度，单位毫米</translation>
    </message>
    <message>
        <source>make the reference anew from the recording</source>
        <translation>由录像重新生成参考</translation>
    </message>
    <message>
        <source>the finger has no markers, so it has no marker table</source>
        <translation>手指没有标记点，因此没有标记点表</translation>
    </message>
    <message>
        <source>set markers.per_row</source>
        <translation>设置 markers.per_row</translation>
    </message>
    <message>
        <source>{}, line {}</source>
        <translation>{}，第 {} 行</translation>
    </message>
    <message>
        <source>not a marker table; its first line must be &apos;{}&apos;</source>
        <translation>不是标记点表；第一行必须是“{}”</translation>
    </message>
    <message>
        <source>the table ends too early</source>
        <translation>表格过早结束</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not close a table of {} frames</source>
        <translation>“{}”不是 {} 帧表格的结尾</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not &apos;{}&apos; with possible values</source>
        <translation>“{}”不是取值合理的“{}”</translation>
    </message>
    <message>
        <source>marker {} stands where marker {} of {} must</source>
        <translation>应为标记点 {1}（共 {2} 个）的位置却是标记点 {0}</translation>
    </message>
    <message>
        <source>frame {} comes after frame {}</source>
        <translation>第 {} 帧排在第 {} 帧之后</translation>
    </message>
    <message>
        <source>frame {} has {} markers instead of {}</source>
        <translation>第 {} 帧有 {} 个标记点，应为 {} 个</translation>
    </message>
    <message>
        <source>marker {} has another radius or contrast than before</source>
        <translation>标记点 {} 的半径或对比度与之前不同</translation>
    </message>
    <message>
        <source>the table holds no frame</source>
        <translation>表中没有帧</translation>
    </message>
    <message>
        <source>stopped before the reference was read</source>
        <translation>读完参考之前已停止</translation>
    </message>
    <message>
        <source>reading reference frame {} of {}</source>
        <translation>正在读取第 {} / {} 个参考帧</translation>
    </message>
    <message>
        <source>the face was found in {} of {} recorded pictures; 2 are needed</source>
        <translation>{1} 张录制图片中有 {0} 张找到了面；需要 2 张</translation>
    </message>
    <message>
        <source>the marker table names frame {} but the recording ends after {} frames</source>
        <translation>标记点表中有第 {} 帧，但录像只有 {} 帧</translation>
    </message>
    <message>
        <source>the recording cannot be read ({})</source>
        <translation>无法读取录像（{}）</translation>
    </message>
    <message>
        <source>the sensor has no untouched picture</source>
        <translation>传感器没有未触碰的图片</translation>
    </message>
    <message>
        <source>give one with the calibration</source>
        <translation>标定时给出一张</translation>
    </message>
    <message>
        <source>the untouched picture</source>
        <translation>未触碰的图片</translation>
    </message>
    <message>
        <source>give the untouched picture anew</source>
        <translation>重新给出未触碰的图片</translation>
    </message>
    <message>
        <source>the finger has no reference recording</source>
        <translation>手指没有参考录像</translation>
    </message>
    <message>
        <source>record the bending, untouched finger and make its reference</source>
        <translation>录制未触碰手指弯曲的过程并生成参考</translation>
    </message>
    <message>
        <source>the reference recording is missing or no video</source>
        <translation>参考录像缺失或不是视频</translation>
    </message>
    <message>
        <source>the recording&apos;s picture</source>
        <translation>录像的图片</translation>
    </message>
    <message>
        <source>the reference picture is not an 8-bit grey picture</source>
        <translation>参考图片不是 8 位灰度图</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>save it as such</source>
        <translation>按该格式保存</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number from {} to {}</source>
        <translation>“{}”不是 {} 到 {} 的数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not {}</source>
        <translation>“{}”不是 {}</translation>
    </message>
    <message>
        <source>depth_mm = {:g} goes through the layer of {:g} mm</source>
        <translation>depth_mm = {} 穿透了 {} mm 的层</translation>
    </message>
    <message>
        <source>less than finger.face.layer_mm</source>
        <translation>小于 finger.face.layer_mm</translation>
    </message>
    <message>
        <source>s_mm is beyond the ends of the face</source>
        <translation>s_mm 超出面的两端</translation>
    </message>
    <message>
        <source>0 to {:g}</source>
        <translation>0 至 {}</translation>
    </message>
    <message>
        <source>y_mm is beside the face</source>
        <translation>y_mm 在面之外</translation>
    </message>
    <message>
        <source>{:g} to {:g}</source>
        <translation>{} 至 {}</translation>
    </message>
    <message>
        <source>the ball would sink in beyond its middle</source>
        <translation>球会陷入超过其中部</translation>
    </message>
    <message>
        <source>depth_mm below radius_mm</source>
        <translation>depth_mm 小于 radius_mm</translation>
    </message>
    <message>
        <source>a flat sensor does not bend</source>
        <translation>平面传感器不会弯曲</translation>
    </message>
    <message>
        <source>leave bend out</source>
        <translation>去掉 bend</translation>
    </message>
    <message>
        <source>nothing presses, so nothing bulges</source>
        <translation>没有按压，因此没有隆起</translation>
    </message>
    <message>
        <source>name ball or relief too</source>
        <translation>同时写上 ball 或 relief</translation>
    </message>
    <message>
        <source>there is no lamp</source>
        <translation>没有灯</translation>
    </message>
    <message>
        <source>- {{at_mm: [x, y, z], power: p}}</source>
        <translation>- {{at_mm: [x, y, z], power: p}}</translation>
    </message>
    <message>
        <source>the lamp aims at itself</source>
        <translation>灯指向自身</translation>
    </message>
    <message>
        <source>another point</source>
        <translation>换一个点</translation>
    </message>
    <message>
        <source>this lobe is not known</source>
        <translation>未知的光束形状</translation>
    </message>
    <message>
        <source>1, 2, 4 or 8</source>
        <translation>1、2、4 或 8</translation>
    </message>
    <message>
        <source>&apos;first&apos; is not below &apos;last&apos;</source>
        <translation>&apos;first&apos; 不小于 &apos;last&apos;</translation>
    </message>
    <message>
        <source>e.g. 0.1 and 0.9</source>
        <translation>例如 0.1 和 0.9</translation>
    </message>
    <message>
        <source>the dots would cut the face&apos;s edge</source>
        <translation>标记点会切到面的边缘</translation>
    </message>
    <message>
        <source>less than setback_mm</source>
        <translation>小于 setback_mm</translation>
    </message>
    <message>
        <source>the finger has no markers</source>
        <translation>手指没有标记点</translation>
    </message>
    <message>
        <source>finger.markers with per_row and polarity</source>
        <translation>写上 finger.markers 的 per_row 和 polarity</translation>
    </message>
    <message>
        <source>markers are engraved in the side faces</source>
        <translation>标记点刻在侧面上</translation>
    </message>
    <message>
        <source>name the effect sides too</source>
        <translation>同时写上效果 sides</translation>
    </message>
    <message>
        <source>JPEG needs whole grey levels</source>
        <translation>JPEG 需要整数灰度级</translation>
    </message>
    <message>
        <source>name the effect quantisation too</source>
        <translation>同时写上效果 quantisation</translation>
    </message>
    <message>
        <source>no dot would ever be hidden</source>
        <translation>不会有任何点被遮住</translation>
    </message>
    <message>
        <source>leave occlusion out, or 1 and more</source>
        <translation>去掉 occlusion，或取 1 以上</translation>
    </message>
    <message>
        <source>{:g} is not a marker&apos;s number</source>
        <translation>{} 不是标记点编号</translation>
    </message>
    <message>
        <source>0, 1, 2, ...</source>
        <translation>0, 1, 2, ...</translation>
    </message>
    <message>
        <source>there are no dots to hide</source>
        <translation>没有可遮住的点</translation>
    </message>
    <message>
        <source>name the effect markers too</source>
        <translation>同时写上效果 markers</translation>
    </message>
    <message>
        <source>there is no marker {}</source>
        <translation>没有标记点 {}</translation>
    </message>
    <message>
        <source>0 to {}</source>
        <translation>0 至 {}</translation>
    </message>
    <message>
        <source>more dots would be hidden than there are</source>
        <translation>要遮住的点多于现有的点</translation>
    </message>
    <message>
        <source>up to {}</source>
        <translation>最多 {}</translation>
    </message>
    <message>
        <source>the bars are wider than the T</source>
        <translation>横条比 T 还宽</translation>
    </message>
    <message>
        <source>less than size_mm</source>
        <translation>小于 size_mm</translation>
    </message>
    <message>
        <source>nothing presses, so nothing rolls off</source>
        <translation>没有按压，因此没有过渡</translation>
    </message>
    <message>
        <source>kind hertz is for balls only</source>
        <translation>kind hertz 只用于球</translation>
    </message>
    <message>
        <source>kind: smooth with a length_mm</source>
        <translation>用 kind: smooth 并给出 length_mm</translation>
    </message>
    <message>
        <source>a flat sensor has no side faces</source>
        <translation>平面传感器没有侧面</translation>
    </message>
    <message>
        <source>leave sides out</source>
        <translation>去掉 sides</translation>
    </message>
    <message>
        <source>an orthographic camera sees no side faces</source>
        <translation>正交相机看不到侧面</translation>
    </message>
    <message>
        <source>a flat sensor does not sway</source>
        <translation>平面传感器不会摆动</translation>
    </message>
    <message>
        <source>leave sway out</source>
        <translation>去掉 sway</translation>
    </message>
    <message>
        <source>a flat sensor does not give way</source>
        <translation>平面传感器不会退让</translation>
    </message>
    <message>
        <source>leave give_mm out</source>
        <translation>去掉 give_mm</translation>
    </message>
    <message>
        <source>the list is empty</source>
        <translation>列表为空</translation>
    </message>
    <message>
        <source>one pose a frame</source>
        <translation>每帧一个姿态</translation>
    </message>
    <message>
        <source>the motion moves &apos;{}&apos;, but no effect of the scene does</source>
        <translation>运动中有“{}”，但场景中没有相应效果</translation>
    </message>
    <message>
        <source>name `bend` or `sway` among the effects</source>
        <translation>在效果中写上 `bend` 或 `sway`</translation>
    </message>
    <message>
        <source>{} = {:g} is outside the effect&apos;s range</source>
        <translation>{} = {} 超出效果的范围</translation>
    </message>
    <message>
        <source>the motion has nothing to move</source>
        <translation>运动没有可移动的对象</translation>
    </message>
    <message>
        <source>name `bend` or `sway` among the effects, or leave the motion out</source>
        <translation>在效果中写上 `bend` 或 `sway`，或去掉运动</translation>
    </message>
    <message>
        <source>scene &apos;{}&apos;: finger.camera</source>
        <translation>场景“{}”：finger.camera</translation>
    </message>
    <message>
        <source>its camera does not give whole grey levels</source>
        <translation>其相机给出的不是整数灰度级</translation>
    </message>
    <message>
        <source>this is not [width, height]</source>
        <translation>这不是 [宽，高]</translation>
    </message>
    <message>
        <source>whole numbers from 16 to 16384</source>
        <translation>16 到 16384 的整数</translation>
    </message>
    <message>
        <source>there is no effect &apos;{}&apos;</source>
        <translation>没有效果 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the effect &apos;{}&apos; is named twice</source>
        <translation>效果 &apos;{}&apos; 出现两次</translation>
    </message>
    <message>
        <source>A ball is pressed into the face</source>
        <translation>一个球压入接触面</translation>
    </message>
    <message>
        <source>The finger bends in the plane of its length</source>
        <translation>手指在其长度所在的平面内弯曲</translation>
    </message>
    <message>
        <source>The layer swells around what presses</source>
        <translation>涂层在压入物周围隆起</translation>
    </message>
    <message>
        <source>Frames get lost on their way</source>
        <translation>帧在传输途中丢失</translation>
    </message>
    <message>
        <source>Frames come late</source>
        <translation>帧迟到</translation>
    </message>
    <message>
        <source>The layer over the black coat is darker where it is thinner</source>
        <translation>黑色涂层上的半透明层越薄越暗</translation>
    </message>
    <message>
        <source>Lamps light the finger</source>
        <translation>灯照亮手指</translation>
    </message>
    <message>
        <source>Dots are engraved in the side faces</source>
        <translation>侧面刻有标记点</translation>
    </message>
    <message>
        <source>The camera sends JPEG pictures</source>
        <translation>相机发送 JPEG 图片</translation>
    </message>
    <message>
        <source>Folds of the side faces hide dots</source>
        <translation>侧面的褶皱遮住标记点</translation>
    </message>
    <message>
        <source>The sensor counts in whole grey levels from 0 to 255</source>
        <translation>传感器以 0 到 255 的整数灰度级计数</translation>
    </message>
    <message>
        <source>Reading the sensor adds noise</source>
        <translation>读取传感器会增加噪声</translation>
    </message>
    <message>
        <source>An object with a relief is pressed into the face</source>
        <translation>一个带浮雕的物体压入接触面</translation>
    </message>
    <message>
        <source>The face comes away softly from what presses</source>
        <translation>接触面从压入物平缓地脱开</translation>
    </message>
    <message>
        <source>Light comes in grains, which is noise that grows with brightness</source>
        <translation>光以颗粒形式到来，这种噪声随亮度增长</translation>
    </message>
    <message>
        <source>The side faces of the body are seen</source>
        <translation>可以看到主体的侧面</translation>
    </message>
    <message>
        <source>The finger leans sideways</source>
        <translation>手指向侧面倾斜</translation>
    </message>
    <message>
        <source>{}, in frames {} to {}</source>
        <translation>{}，在第 {} 到 {} 帧</translation>
    </message>
    <message>
        <source>its camera does not give whole grey levels in frames {} to {}</source>
        <translation>其相机在第 {} 到 {} 帧给出的不是整数灰度级</translation>
    </message>
    <message>
        <source>name the effect quantisation for all frames</source>
        <translation>请为所有帧写明效果 quantisation</translation>
    </message>
    <message>
        <source>the effect &apos;{}&apos; is named twice for frames {} to {}</source>
        <translation>效果 &apos;{}&apos; 在第 {} 到 {} 帧出现两次</translation>
    </message>
    <message>
        <source>let one end with &apos;until&apos; before the other begins with &apos;from&apos;</source>
        <translation>让其中一个用 &apos;until&apos; 结束，再让另一个用 &apos;from&apos; 开始</translation>
    </message>
    <message>
        <source>must be a point in time, not &apos;{}&apos;</source>
        <translation>必须是一个时间点，而不是 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>a frame such as 60, or seconds such as 2 s</source>
        <translation>帧号，如 60，或秒数，如 2 s</translation>
    </message>
    <message>
        <source>the scene ends before that</source>
        <translation>场景在此之前已结束</translation>
    </message>
    <message>
        <source>one of its frames, 0 to {}</source>
        <translation>其中一帧，0 到 {}</translation>
    </message>
    <message>
        <source>it would never be there, for it begins with frame {}</source>
        <translation>它永远不会出现，因为它从第 {} 帧开始</translation>
    </message>
    <message>
        <source>a later frame, or leave the effect out</source>
        <translation>更晚的帧，或者去掉该效果</translation>
    </message>
    <message>
        <source>the key frame before it stands there too</source>
        <translation>前一个关键帧也在此处</translation>
    </message>
    <message>
        <source>a later time, or leave one of the two out</source>
        <translation>更晚的时间，或者去掉其中一个</translation>
    </message>
    <message>
        <source>the key frame before it is a later one</source>
        <translation>前一个关键帧的时间更晚</translation>
    </message>
    <message>
        <source>key frames in the order of their times</source>
        <translation>按时间顺序排列关键帧</translation>
    </message>
    <message>
        <source>this is not a text</source>
        <translation>这不是文本</translation>
    </message>
    <message>
        <source>a word or a sentence</source>
        <translation>单词或句子</translation>
    </message>
    <message>
        <source>one number a frame</source>
        <translation>每帧一个数</translation>
    </message>
    <message>
        <source>&apos;from&apos; is not below &apos;to&apos;</source>
        <translation>&apos;from&apos; 不小于 &apos;to&apos;</translation>
    </message>
    <message>
        <source>a range that grows</source>
        <translation>递增的范围</translation>
    </message>
    <message>
        <source>the folder cannot be read: {}</source>
        <translation>无法读取文件夹：{}</translation>
    </message>
    <message>
        <source>ask its owner for access</source>
        <translation>向其所有者申请权限</translation>
    </message>
    <message>
        <source>the folder holds no pictures</source>
        <translation>文件夹中没有图片</translation>
    </message>
    <message>
        <source>a folder with png, jpg, bmp, tif or pgm files</source>
        <translation>含有 png、jpg、bmp、tif 或 pgm 文件的文件夹</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>灯光</translation>
    </message>
    <message>
        <source>{} was {} and is {}</source>
        <translation>{} 原为 {}，现为 {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; describes no button</source>
        <translation>“{}”没有描述按钮</translation>
    </message>
    <message>
        <source>learn the button again</source>
        <translation>重新学习按钮</translation>
    </message>
    <message>
        <source>&apos;{}&apos; names no device and its button</source>
        <translation>“{}”没有指明设备及其按钮</translation>
    </message>
    <message>
        <source>&apos;alltact devices --learn-button&apos;, which says what to write here</source>
        <translation>运行 &apos;alltact devices --learn-button&apos;，它会说明这里该写什么</translation>
    </message>
    <message>
        <source>learning the button was stopped</source>
        <translation>学习按钮已停止</translation>
    </message>
    <message>
        <source>press it now, twice</source>
        <translation>现在按两次</translation>
    </message>
    <message>
        <source>press it once more</source>
        <translation>再按一次</translation>
    </message>
    <message>
        <source>no button was pressed and let go twice</source>
        <translation>没有按钮被按下并松开两次</translation>
    </message>
    <message>
        <source>another device; a pedal that only clicks must be set to send a key</source>
        <translation>换一个设备；只会点击的脚踏开关须设为发送按键</translation>
    </message>
    <message>
        <source>the device cannot be opened</source>
        <translation>无法打开设备</translation>
    </message>
    <message>
        <source>unplug it and plug it in again</source>
        <translation>拔下再插上</translation>
    </message>
    <message>
        <source>access to the device is not allowed</source>
        <translation>没有访问设备的权限</translation>
    </message>
    <message>
        <source>install packaging/70-alltact.rules in /etc/udev/rules.d and plug it in again; a device it does not name needs this line in it: KERNEL==&quot;hidraw*&quot;, ATTRS{{idVendor}}==&quot;{:04x}&quot;, ATTRS{{idProduct}}==&quot;{:04x}&quot;, TAG+=&quot;uaccess&quot;</source>
        <translation>把 packaging/70-alltact.rules 装到 /etc/udev/rules.d 后重新插上；其中没有列出的设备需要加上这一行：KERNEL==&quot;hidraw*&quot;, ATTRS{{idVendor}}==&quot;{}&quot;, ATTRS{{idProduct}}==&quot;{}&quot;, TAG+=&quot;uaccess&quot;</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>设备已拔出</translation>
    </message>
    <message>
        <source>plug it in again</source>
        <translation>重新插上</translation>
    </message>
    <message>
        <source>the device took no report</source>
        <translation>设备不接受报告</translation>
    </message>
    <message>
        <source>plug it in again, and check its description</source>
        <translation>重新插上，并检查其描述</translation>
    </message>
    <message>
        <source>no HID device was found</source>
        <translation>没有找到 HID 设备</translation>
    </message>
    <message>
        <source>there is no such HID device; there is {}</source>
        <translation>没有这样的 HID 设备；现有 {}</translation>
    </message>
    <message>
        <source>plug it in; &apos;alltact devices&apos; lists what is found</source>
        <translation>插上设备；&apos;alltact devices&apos; 列出找到的设备</translation>
    </message>
    <message>
        <source>&apos;{}&apos; describes no dimmer</source>
        <translation>“{}”没有描述调光器</translation>
    </message>
    <message>
        <source>mcp2221a gp2, mcp2221a gp3, or a report such as &apos;output id=0 bytes=8 at=1 range=0..255&apos;</source>
        <translation>mcp2221a gp2、mcp2221a gp3，或如 &apos;output id=0 bytes=8 at=1 range=0..255&apos; 的报告</translation>
    </message>
    <message>
        <source>the brightness {} is not from 0 to 1</source>
        <translation>亮度 {} 不在 0 到 1 之间</translation>
    </message>
    <message>
        <source>the MCP2221A did not answer as it should</source>
        <translation>MCP2221A 的应答不正确</translation>
    </message>
    <message>
        <source>plug it in again; close other programs that use it</source>
        <translation>重新插上；关闭使用它的其他程序</translation>
    </message>
    <message>
        <source>this is neither a picture, nor a folder of pictures, nor a video, nor a scene</source>
        <translation>这不是图片、图片文件夹、视频或场景</translation>
    </message>
    <message>
        <source>png, jpg, bmp, tif or pgm pictures, a mkv, avi or mp4 video, or a yaml scene</source>
        <translation>png、jpg、bmp、tif 或 pgm 图片，mkv、avi 或 mp4 视频，或 yaml 场景</translation>
    </message>
    <message>
        <source>video</source>
        <translation>视频</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>a {} cannot be mixed with other inputs</source>
        <translation>{}不能与其他输入混用</translation>
    </message>
    <message>
        <source>it alone, or pictures only</source>
        <translation>单独使用它，或只用图片</translation>
    </message>
    <message>
        <source>no input was given</source>
        <translation>没有给出输入</translation>
    </message>
    <message>
        <source>name a picture, a folder of pictures, a video, a scene or a camera</source>
        <translation>指定图片、图片文件夹、视频、场景或相机</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>没有这样的文件或文件夹</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be read</source>
        <translation>无法读取“{}”</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be set to {}</source>
        <translation>无法把“{}”设为 {}</translation>
    </message>
    <message>
        <source>the camera refuses this value</source>
        <translation>相机拒绝此值</translation>
    </message>
    <message>
        <source>a value within its range; &apos;alltact devices --details&apos; lists them</source>
        <translation>使用范围内的值；&apos;alltact devices --details&apos; 列出范围</translation>
    </message>
    <message>
        <source>an automatic mode has it in hand</source>
        <translation>正由自动模式控制</translation>
    </message>
    <message>
        <source>switch that mode off first</source>
        <translation>先关闭该自动模式</translation>
    </message>
    <message>
        <source>the camera took {} instead</source>
        <translation>相机改用了 {}</translation>
    </message>
    <message>
        <source>a value within its range and steps; &apos;alltact devices --details&apos; lists them</source>
        <translation>使用范围和步长之内的值；&apos;alltact devices --details&apos; 列出它们</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be switched off: brightness may drift</source>
        <translation>无法关闭“{}”：亮度可能漂移</translation>
    </message>
    <message>
        <source>it sends its pictures in several planes, which cannot be read here</source>
        <translation>它用多个平面传送图像，这里无法读取</translation>
    </message>
    <message>
        <source>a USB camera</source>
        <translation>使用 USB 相机</translation>
    </message>
    <message>
        <source>it cannot stream</source>
        <translation>它不能传送视频流</translation>
    </message>
    <message>
        <source>it has no format that can be read here</source>
        <translation>它没有这里能读取的格式</translation>
    </message>
    <message>
        <source>a camera with MJPG or YUYV</source>
        <translation>使用支持 MJPG 或 YUYV 的相机</translation>
    </message>
    <message>
        <source>it cannot be used now</source>
        <translation>现在无法使用</translation>
    </message>
    <message>
        <source>the camera is not there</source>
        <translation>相机不在</translation>
    </message>
    <message>
        <source>plug it in</source>
        <translation>插上它</translation>
    </message>
    <message>
        <source>several cameras have this name: {}</source>
        <translation>有多台相机同名：{}</translation>
    </message>
    <message>
        <source>the name before the brackets</source>
        <translation>括号前的名字</translation>
    </message>
    <message>
        <source>no camera was found</source>
        <translation>没有找到相机</translation>
    </message>
    <message>
        <source>there is no such camera; there is {}</source>
        <translation>没有这样的相机；现有 {}</translation>
    </message>
    <message>
        <source>plug one in; &apos;alltact devices&apos; lists what is found</source>
        <translation>插上一台；&apos;alltact devices&apos; 列出找到的设备</translation>
    </message>
    <message>
        <source>one of these names</source>
        <translation>使用其中一个名字</translation>
    </message>
    <message>
        <source>the camera has sent no picture for a second</source>
        <translation>相机已有一秒没有送出图像</translation>
    </message>
    <message>
        <source>look after the cable and the USB port</source>
        <translation>检查线缆和 USB 接口</translation>
    </message>
    <message>
        <source>this node gives no pictures that can be read</source>
        <translation>此设备节点不提供可读取的图像</translation>
    </message>
    <message>
        <source>a camera that &apos;alltact devices&apos; lists as usable</source>
        <translation>使用 &apos;alltact devices&apos; 列为可用的相机</translation>
    </message>
    <message>
        <source>the camera stopped sending pictures</source>
        <translation>相机停止送出图像</translation>
    </message>
    <message>
        <source>no picture came for {:.1f} seconds</source>
        <translation>已有 {} 秒没有收到图像</translation>
    </message>
    <message>
        <source>look after the cable and the USB port; the stream is being started again</source>
        <translation>检查线缆和 USB 接口；正在重新启动视频流</translation>
    </message>
    <message>
        <source>a picture cannot be taken</source>
        <translation>无法取得图像</translation>
    </message>
    <message>
        <source>Pictures come again</source>
        <translation>又收到图像了</translation>
    </message>
    <message>
        <source>the camera is back and has not sent a picture yet</source>
        <translation>相机已接回，尚未送出图像</translation>
    </message>
    <message>
        <source>The camera was plugged in again at {}</source>
        <translation>相机已重新插上，位于 {}</translation>
    </message>
    <message>
        <source>the camera&apos;s signal changed: it sent {}, and sends {} now</source>
        <translation>相机信号已改变：原为 {}，现为 {}</translation>
    </message>
    <message>
        <source>look after what is plugged into it, if this was not meant</source>
        <translation>若非有意，请检查它上面接的是什么</translation>
    </message>
    <message>
        <source>the camera was unplugged</source>
        <translation>相机已拔出</translation>
    </message>
    <message>
        <source>plug it in again; it goes on by itself with the same settings</source>
        <translation>重新插上；会自动以相同设置继续</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed from {} to {} by something else</source>
        <translation>“{}”被其他程序从 {} 改为 {}</translation>
    </message>
    <message>
        <source>it was put back</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>sudo usermod -aG video $USER, then log in again; or install packaging/70-alltact.rules in /etc/udev/rules.d and plug the camera in again</source>
        <translation>运行 sudo usermod -aG video $USER 后重新登录；或把 packaging/70-alltact.rules 装到 /etc/udev/rules.d 后重新插上相机</translation>
    </message>
    <message>
        <source>another program is using it</source>
        <translation>另一程序正在使用它</translation>
    </message>
    <message>
        <source>close that program (fuser -v /dev/video* names it)</source>
        <translation>关闭该程序（fuser -v /dev/video* 可查出它）</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>它不在</translation>
    </message>
    <message>
        <source>plug the camera in; &apos;alltact devices&apos; lists what is found</source>
        <translation>插上相机；&apos;alltact devices&apos; 列出找到的设备</translation>
    </message>
    <message>
        <source>the USB port has no bandwidth left</source>
        <translation>USB 接口带宽已用完</translation>
    </message>
    <message>
        <source>another USB port, MJPG instead of YUYV, or smaller pictures</source>
        <translation>换一个 USB 接口、用 MJPG 代替 YUYV，或用更小的图像</translation>
    </message>
    <message>
        <source>the USB connection is disturbed</source>
        <translation>USB 连接受到干扰</translation>
    </message>
    <message>
        <source>a shorter cable or another port</source>
        <translation>换短一些的线或另一接口</translation>
    </message>
    <message>
        <source>the camera refuses</source>
        <translation>相机拒绝</translation>
    </message>
    <message>
        <source>another format or value; &apos;alltact devices --details&apos; lists them</source>
        <translation>换一种格式或值；&apos;alltact devices --details&apos; 列出它们</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>unplug the camera and plug it in again</source>
        <translation>拔下相机再插上</translation>
    </message>
    <message>
        <source>{} and more</source>
        <translation>{} 等</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>{} at {:g} frames per second</source>
        <translation>{}，每秒 {} 帧</translation>
    </message>
    <message>
        <source>the camera has no such format that can be read; it offers {}</source>
        <translation>相机没有这种可读取的格式；它提供 {}</translation>
    </message>
    <message>
        <source>one of these in GREY, Y16, YUYV or MJPG</source>
        <translation>选用其中的 GREY、Y16、YUYV 或 MJPG 格式</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>无法打开相机</translation>
    </message>
    <message>
        <source>this does not answer as a camera</source>
        <translation>它的应答不像相机</translation>
    </message>
    <message>
        <source>the camera&apos;s format cannot be set to {}</source>
        <translation>无法把相机格式设为 {}</translation>
    </message>
    <message>
        <source>the camera was asked for {} and chose {}</source>
        <translation>向相机要求 {}，它选了 {}</translation>
    </message>
    <message>
        <source>a format that &apos;alltact devices --details&apos; lists for it</source>
        <translation>使用 &apos;alltact devices --details&apos; 为它列出的格式</translation>
    </message>
    <message>
        <source>the camera&apos;s rate cannot be set</source>
        <translation>无法设置相机帧率</translation>
    </message>
    <message>
        <source>the camera takes no buffer</source>
        <translation>相机不接受缓冲区</translation>
    </message>
    <message>
        <source>the camera does not start</source>
        <translation>相机没有启动</translation>
    </message>
    <message>
        <source>the camera gives no buffers</source>
        <translation>相机没有提供缓冲区</translation>
    </message>
    <message>
        <source>the camera&apos;s buffer cannot be found</source>
        <translation>找不到相机的缓冲区</translation>
    </message>
    <message>
        <source>the camera&apos;s buffer cannot be mapped</source>
        <translation>无法映射相机的缓冲区</translation>
    </message>
    <message>
        <source>holds more than one document</source>
        <translation>含有多个文档</translation>
    </message>
    <message>
        <source>leave out the lines &apos;---&apos;</source>
        <translation>去掉 &apos;---&apos; 行</translation>
    </message>
    <message>
        <source>this is not YAML: {}</source>
        <translation>这不是 YAML：{}</translation>
    </message>
    <message>
        <source>look at the brackets, quotes and the space before each key</source>
        <translation>检查括号、引号以及每个键前的空格</translation>
    </message>
    <message>
        <source>is too large to be read</source>
        <translation>太大，无法读取</translation>
    </message>
    <message>
        <source>a file of fewer entries</source>
        <translation>使用条目较少的文件</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;</source>
        <translation>未知的键 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>is not known, and too large or too odd to be kept</source>
        <translation>是未知的，而且太大或太奇怪，无法保留</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>删除它</translation>
    </message>
    <message>
        <source>is not known here; it is kept as it is</source>
        <translation>在这里是未知的；按原样保留</translation>
    </message>
    <message>
        <source>&apos;{}&apos;</source>
        <translation>“{}”</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>a block of keys</source>
        <translation>键的段落</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>above</source>
        <translation>大于</translation>
    </message>
    <message>
        <source>from</source>
        <translation>不小于</translation>
    </message>
    <message>
        <source>below</source>
        <translation>小于</translation>
    </message>
    <message>
        <source>up to</source>
        <translation>不大于</translation>
    </message>
    <message>
        <source>a number {} {:g} and {} {:g}</source>
        <translation>{} {} 且{} {} 的数</translation>
    </message>
    <message>
        <source>a number such as 24.0, with a point and without a unit</source>
        <translation>如 24.0 的数字，用小数点，不带单位</translation>
    </message>
    <message>
        <source>must be a block of &apos;key: value&apos; lines, not {}</source>
        <translation>必须是由 &apos;key: value&apos; 行组成的段落，而不是{}</translation>
    </message>
    <message>
        <source>compare with another file of this kind</source>
        <translation>与另一个同类文件比较</translation>
    </message>
    <message>
        <source>holds a key that is not a word</source>
        <translation>含有不是单词的键</translation>
    </message>
    <message>
        <source>one word before each colon</source>
        <translation>每个冒号前一个单词</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>出现两次</translation>
    </message>
    <message>
        <source>leave one of the two</source>
        <translation>只保留其中一个</translation>
    </message>
    <message>
        <source>add &apos;{}: ...&apos;</source>
        <translation>添加 &apos;{}: ...&apos;</translation>
    </message>
    <message>
        <source>add &apos;{}: ...&apos; under &apos;{}:&apos;</source>
        <translation>在 &apos;{1}:&apos; 下添加 &apos;{0}: ...&apos;</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>write &apos;{}&apos; for &apos;{}&apos;</source>
        <translation>把“{1}”写成“{0}”</translation>
    </message>
    <message>
        <source>must be a text, not {}</source>
        <translation>必须是文本，而不是{}</translation>
    </message>
    <message>
        <source>{} is not known here</source>
        <translation>{}在这里是未知的</translation>
    </message>
    <message>
        <source>must be a number, {}, not {}</source>
        <translation>必须是数字，{}，而不是{}</translation>
    </message>
    <message>
        <source>0 would mean that this is absent, and what is absent is not named</source>
        <translation>0 表示没有，没有的就不要写</translation>
    </message>
    <message>
        <source>leave it out, or give {}</source>
        <translation>去掉它，或给出{}</translation>
    </message>
    <message>
        <source>holds {}, which is not {}</source>
        <translation>含有 {}，不是{}</translation>
    </message>
    <message>
        <source>must be {}, not {}</source>
        <translation>必须是{}，而不是{}</translation>
    </message>
    <message>
        <source>must be a whole number from {} to {}, not {}</source>
        <translation>必须是 {} 到 {} 的整数，而不是{}</translation>
    </message>
    <message>
        <source>must be a list, not {}</source>
        <translation>必须是列表，而不是{}</translation>
    </message>
    <message>
        <source>[..., ...]</source>
        <translation>[..., ...]</translation>
    </message>
    <message>
        <source>this is not a list of the right length</source>
        <translation>这不是长度正确的列表</translation>
    </message>
    <message>
        <source>[{} numbers]</source>
        <translation>[{} 个数]</translation>
    </message>
    <message>
        <source>[{} to {} numbers]</source>
        <translation>[{} 到 {} 个数]</translation>
    </message>
    <message>
        <source>holds {}, which is not a text</source>
        <translation>含有 {}，不是文本</translation>
    </message>
    <message>
        <source>holds {}, which is not a list</source>
        <translation>含有 {}，不是列表</translation>
    </message>
    <message>
        <source>[[..., ...], ...]</source>
        <translation>[[..., ...], ...]</translation>
    </message>
    <message>
        <source>{}:{}: this is no check and is left out.</source>
        <translation>{}:{}：这不是检查记录，已舍弃。</translation>
    </message>
    <message>
        <source>no untouched picture; give one to calibrate with --reference</source>
        <translation>没有未触碰的图片；标定时请用 --reference 给出</translation>
    </message>
    <message>
        <source>no recording of the bending, untouched finger; run alltact reference</source>
        <translation>没有未触碰手指弯曲的录像；请运行 alltact reference</translation>
    </message>
    <message>
        <source>one untouched picture</source>
        <translation>一张未触碰的图片</translation>
    </message>
    <message>
        <source>only {} frames; poses between them are guessed, record more bending</source>
        <translation>只有 {} 帧；其间的姿态是推测的，请多录一些弯曲</translation>
    </message>
    <message numerus="yes">
        <source>{} frames</source>
        <comment>{} frame</comment>
        <translation>
            <numerusform>{} 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>no layout at rest, so touch cannot be told; run alltact reference again</source>
        <translation>没有静止时的排布，无法判断触碰；请重新运行 alltact reference</translation>
    </message>
    <message>
        <source>none; poses are told by the shape of the face, which cannot tell twist</source>
        <translation>没有；姿态由面的形状判断，无法判断扭转</translation>
    </message>
    <message>
        <source>{} markers; touch is told from {:.1f} px of summed offset</source>
        <translation>{} 个标记点；位移总和达 {} px 即判为触碰</translation>
    </message>
    <message>
        <source>not calibrated; run alltact calibrate with ball presses</source>
        <translation>未标定；请用球按压运行 alltact calibrate</translation>
    </message>
    <message>
        <source>nothing says how it came about or how good it is; run alltact calibrate again</source>
        <translation>没有记录它的来源和质量；请重新运行 alltact calibrate</translation>
    </message>
    <message>
        <source>made at an unknown date</source>
        <translation>制作日期不明</translation>
    </message>
    <message>
        <source>made {}</source>
        <translation>制作于 {}</translation>
    </message>
    <message>
        <source>the calibration cannot be repeated: {}.</source>
        <translation>标定无法重复：{}。</translation>
    </message>
    <message>
        <source>{} of {} press pictures are gone, so the calibration cannot be repeated</source>
        <translation>{1} 张按压图片中有 {0} 张已不在，标定无法重复</translation>
    </message>
    <message>
        <source>what is kept is of a calibration that was cut off; complete it with {}</source>
        <translation>保存的内容来自一次中断的标定；请用 {} 完成</translation>
    </message>
    <message>
        <source>{} pictures kept</source>
        <translation>保存了 {} 张图片</translation>
    </message>
    <message>
        <source>{}, {} x {} px</source>
        <translation>{}，{} x {} px</translation>
    </message>
    <message>
        <source>stopped before the check was done</source>
        <translation>检查完成前已停止</translation>
    </message>
    <message>
        <source>{}: the contact covers too few pixels</source>
        <translation>{}：接触覆盖的像素太少</translation>
    </message>
    <message>
        <source>pressing deeper, or a larger picture</source>
        <translation>压得更深，或使用更大的图片</translation>
    </message>
    <message>
        <source>{}: no ball fits the contact</source>
        <translation>{}：没有球与接触相符</translation>
    </message>
    <message>
        <source>a clean ball</source>
        <translation>使用干净的球</translation>
    </message>
    <message>
        <source>{} {}</source>
        <translation>{} {}</translation>
    </message>
    <message>
        <source>no face was found</source>
        <translation>没有找到面</translation>
    </message>
    <message>
        <source>the contacts have no ball&apos;s shape: is ball or face dirty?</source>
        <translation>接触不是球形：球或面脏了吗？</translation>
    </message>
    <message>
        <source>shallow</source>
        <translation>浅</translation>
    </message>
    <message>
        <source>deep</source>
        <translation>深</translation>
    </message>
    <message>
        <source>the mapping reads {:.0f} % too {}: layer, ball or camera are not what they were</source>
        <translation>映射的读数偏{1} {0} %：层、球或相机与从前不同</translation>
    </message>
    <message>
        <source>brighter</source>
        <translation>亮</translation>
    </message>
    <message>
        <source>darker</source>
        <translation>暗</translation>
    </message>
    <message>
        <source>the face is {:.1f} % {} than it was: look at lamps, exposure and layer</source>
        <translation>面比从前{1} {0} %：请检查灯、曝光和层</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>drifting</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>recalibrate</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>calibrate again soon</source>
        <translation>请尽快重新标定</translation>
    </message>
    <message>
        <source>calibrate again before measuring with it</source>
        <translation>测量前请重新标定</translation>
    </message>
    <message>
        <source>the finger is not calibrated, so there is nothing to check</source>
        <translation>手指尚未标定，没有可检查的内容</translation>
    </message>
    <message>
        <source>alltact calibrate</source>
        <translation>alltact calibrate</translation>
    </message>
    <message>
        <source>the finger does not tell the ball it was calibrated with</source>
        <translation>手指没有记录标定时所用的球</translation>
    </message>
    <message>
        <source>--ball-radius-mm with the radius of the ball that was pressed</source>
        <translation>用 --ball-radius-mm 给出压入的球的半径</translation>
    </message>
    <message>
        <source>measuring the presses</source>
        <translation>正在测量按压</translation>
    </message>
    <message>
        <source>no press is called &apos;{}&apos;</source>
        <translation>没有叫“{}”的按压</translation>
    </message>
    <message>
        <source>no press can be used: {}</source>
        <translation>没有可用的按压：{}</translation>
    </message>
    <message>
        <source>pictures of this finger with the ball pressed 0.3 mm or more into its face</source>
        <translation>球压入此手指的面 0.3 mm 以上的图片</translation>
    </message>
    <message>
        <source>measuring the presses of the calibration</source>
        <translation>正在测量标定时的按压</translation>
    </message>
    <message>
        <source>the face is {:.1f} % {} than when its reference was recorded; false depth {:.3f} mm in the worst twentieth of it ({:.3f} mm if the light were not corrected; up to {:.3f} mm is noise)</source>
        <translation>面比录制参考时{1} {0} %；最差的二十分之一处虚假深度为 {2} mm（不作光照校正则为 {3} mm；不超过 {4} mm 属于噪声）</translation>
    </message>
    <message>
        <source>let the lamps warm up, look at exposure and gain, and record the reference again when it goes on</source>
        <translation>让灯预热，检查曝光和增益，若仍如此请重新录制参考</translation>
    </message>
    <message>
        <source>the finger is not calibrated yet</source>
        <translation>手指尚未标定</translation>
    </message>
    <message>
        <source>calibrate with ball presses</source>
        <translation>用球按压进行标定</translation>
    </message>
    <message>
        <source>nothing could be measured</source>
        <translation>什么都无法测量</translation>
    </message>
    <message>
        <source>none of the pictures can be compared with the reference</source>
        <translation>没有一张图片能与参考比较</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{}({})</translation>
    </message>
    <message>
        <source>pictures of the untouched finger in poses that were recorded</source>
        <translation>未触碰的手指在已录制姿态下的图片</translation>
    </message>
    <message>
        <source>an orthographic camera</source>
        <translation>正交相机</translation>
    </message>
    <message>
        <source>a camera behind a window</source>
        <translation>隔着窗口的相机</translation>
    </message>
    <message>
        <source>{} has no camera matrix, so {} has no form for it</source>
        <translation>{}没有相机矩阵，因此 {} 没有对应的形式</translation>
    </message>
    <message>
        <source>json, or zip for the whole finger</source>
        <translation>json，或用 zip 导出整个手指</translation>
    </message>
    <message>
        <source>is a link to another folder, which a zip cannot hold</source>
        <translation>是指向另一文件夹的链接，zip 无法包含</translation>
    </message>
    <message>
        <source>is neither a file nor a folder, so a zip cannot hold it</source>
        <translation>既不是文件也不是文件夹，zip 无法包含</translation>
    </message>
    <message>
        <source>moving it out of the finger&apos;s folder</source>
        <translation>把它移出手指的文件夹</translation>
    </message>
    <message>
        <source>the finger&apos;s folder could not be read: {}</source>
        <translation>无法读取手指的文件夹：{}</translation>
    </message>
    <message>
        <source>its permissions, and that its disk is there</source>
        <translation>检查其权限，以及磁盘是否在</translation>
    </message>
    <message>
        <source>a zip of the finger cannot lie in the finger&apos;s own folder</source>
        <translation>手指的 zip 不能放在手指自己的文件夹里</translation>
    </message>
    <message>
        <source>another folder</source>
        <translation>换一个文件夹</translation>
    </message>
    <message>
        <source>stopped before it was written</source>
        <translation>写完之前已停止</translation>
    </message>
    <message>
        <source>The finger has another reference than it was calibrated with: this is a new calibration.</source>
        <translation>手指的参考与标定时不同：这是一次新的标定。</translation>
    </message>
    <message>
        <source>The finger&apos;s camera, face or markers are not what they were when it was calibrated: this is a new calibration.</source>
        <translation>手指的相机、面或标记点与标定时不同：这是一次新的标定。</translation>
    </message>
    <message>
        <source>The finger was calibrated by version {}: this is a new calibration, by version {}.</source>
        <translation>手指是用版本 {} 标定的：这是用版本 {} 进行的新标定。</translation>
    </message>
    <message>
        <source>writing the report</source>
        <translation>正在写报告</translation>
    </message>
    <message>
        <source>its camera, face or markers were changed while it was calibrated</source>
        <translation>标定期间其相机、面或标记点被更改</translation>
    </message>
    <message>
        <source>calibrating again</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>only a flat sensor has one untouched picture</source>
        <translation>只有平面传感器才有单张未触碰图片</translation>
    </message>
    <message>
        <source>leaving --reference out; this finger is compared with its reference recording</source>
        <translation>去掉 --reference；此手指与其参考录像比较</translation>
    </message>
    <message>
        <source>{} shows what was found</source>
        <translation>{} 显示找到的内容</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>is no checksum of 16 digits</source>
        <translation>不是 16 位的校验和</translation>
    </message>
    <message>
        <source>names no press</source>
        <translation>没有列出按压</translation>
    </message>
    <message>
        <source>has {} entries for {} presses</source>
        <translation>有 {} 项，而按压有 {} 次</translation>
    </message>
    <message>
        <source>one for each press</source>
        <translation>每次按压一项</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no picture&apos;s name</source>
        <translation>“{}”不是图片名</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no checksum of 16 digits</source>
        <translation>“{}”不是 16 位的校验和</translation>
    </message>
    <message>
        <source>names &apos;{}&apos; twice</source>
        <translation>“{}”出现两次</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not among the presses, and something is said of it</source>
        <translation>&apos;{}&apos; 不在按压之中，却有关于它的说明</translation>
    </message>
    <message>
        <source>remove that</source>
        <translation>请将其删除</translation>
    </message>
    <message>
        <source>the version of this program that wrote it, or calibrating again with the pictures in presses/ (this version writes &apos;{}&apos;)</source>
        <translation>使用写出它的程序版本，或用 presses/ 中的图片重新标定（此版本写出“{}”）</translation>
    </message>
    <message>
        <source>there is nothing to repeat: this finger was not calibrated, or by a version that did not keep what with</source>
        <translation>没有可重复的内容：此手指未标定，或标定它的版本没有保存所用的数据</translation>
    </message>
    <message>
        <source>calibrating it with the pictures in presses/ and --ball-radius-mm</source>
        <translation>用 presses/ 中的图片和 --ball-radius-mm 标定</translation>
    </message>
    <message>
        <source>{:.3f} mm, more than three times the others; look at the picture, or leave it out</source>
        <translation>{} mm，超过其他按压的三倍；请查看图片，或舍弃它</translation>
    </message>
    <message>
        <source>only the joint method uses measured depths and punches with a step</source>
        <translation>只有联合方法使用测得的深度和带台阶的压头</translation>
    </message>
    <message>
        <source>leaving them out, or --method joint</source>
        <translation>不使用它们，或使用 --method joint</translation>
    </message>
    <message>
        <source>no press can be used</source>
        <translation>没有可用的按压</translation>
    </message>
    <message>
        <source>pictures of this finger with a ball pressed into its face</source>
        <translation>此手指的面被球压入时的图片</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>正在求解</translation>
    </message>
    <message>
        <source>stopped before the end: this is the best solution until then, without a report; calibrating again from what is kept finishes it</source>
        <translation>提前停止：这是到那时为止最好的解，没有报告；用已保存的内容重新标定即可完成</translation>
    </message>
    <message>
        <source>comparing with other methods</source>
        <translation>正在与其他方法比较</translation>
    </message>
    <message>
        <source>stopped before the calibration was done</source>
        <translation>标定完成前已停止</translation>
    </message>
    <message>
        <source>the reference picture</source>
        <translation>参考图片</translation>
    </message>
    <message>
        <source>the untouched picture of this sensor, at the size of its presses</source>
        <translation>此传感器未触碰的图片，尺寸与按压图片相同</translation>
    </message>
    <message>
        <source>this is not the picture that the finger was calibrated with</source>
        <translation>这不是标定此手指时所用的图片</translation>
    </message>
    <message>
        <source>calibrating anew with the pictures that are there</source>
        <translation>用现有的图片重新标定</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>or --bursts where each video shows one press held still</source>
        <translation>或者在每段视频各显示一次保持静止的按压时使用 --bursts</translation>
    </message>
    <message>
        <source>two presses are called &apos;{}&apos;</source>
        <translation>有两次按压都叫“{}”</translation>
    </message>
    <message>
        <source>giving the pictures different names; they are kept by name with the finger</source>
        <translation>给图片取不同的名字；它们按名字保存在手指中</translation>
    </message>
    <message>
        <source>reading {}</source>
        <translation>正在读取 {}</translation>
    </message>
    <message>
        <source>no press was given</source>
        <translation>没有给出按压</translation>
    </message>
    <message>
        <source>at least one picture of a pressed ball</source>
        <translation>至少一张压入球的图片</translation>
    </message>
    <message>
        <source>there are only presses of a punch with a step</source>
        <translation>只有带台阶压头的按压</translation>
    </message>
    <message>
        <source>pressing a ball as well, once at least: a step tells how far apart two depths are, not where they begin</source>
        <translation>至少再用球按压一次：台阶只说明两个深度相差多少，不说明从哪里算起</translation>
    </message>
    <message>
        <source>none of {} presses could be used: {}</source>
        <translation>{} 次按压都不可用：{}</translation>
    </message>
    <message>
        <source>pictures in which the ball, and nothing else, is pressed 0.3 mm or more into the face</source>
        <translation>只有球压入面 0.3 mm 以上的图片</translation>
    </message>
    <message>
        <source>stopped before there was a solution</source>
        <translation>得到解之前已停止</translation>
    </message>
    <message>
        <source>the ball lies {:.1f} mm deep in a layer of {:g} mm</source>
        <translation>球压入 {} mm，而该层只有 {} mm 厚</translation>
    </message>
    <message>
        <source>pressing less deep, and checking the ball&apos;s radius and the camera&apos;s scale in mm per px</source>
        <translation>压得浅一些，并检查球的半径和相机的比例（mm/px）</translation>
    </message>
    <message>
        <source>no increasing mapping fits the presses</source>
        <translation>没有递增的映射与按压相符</translation>
    </message>
    <message>
        <source>leaving out presses with the largest residual, a lower degree, or checking the ball&apos;s radius</source>
        <translation>舍弃残差最大的按压、降低次数，或检查球的半径</translation>
    </message>
    <message>
        <source>solving: round {}, unknowns move by {:.1e} mm</source>
        <translation>正在求解：第 {} 轮，未知量变动 {} mm</translation>
    </message>
    <message>
        <source>solving all presses together</source>
        <translation>正在对全部按压联合求解</translation>
    </message>
    <message>
        <source>{}, because the {} does not increase on all samples</source>
        <translation>{}，因为{}在全部样本上并非处处递增</translation>
    </message>
    <message>
        <source>the solution is no mapping: {}</source>
        <translation>解不是有效的映射：{}</translation>
    </message>
    <message>
        <source>more presses of different depth, or a lower degree</source>
        <translation>增加不同深度的按压，或降低次数</translation>
    </message>
    <message>
        <source>one press cannot separate the ball&apos;s depth from the mapping: add presses of different depth at other places</source>
        <translation>一次按压无法区分球的深度与映射：请在其他位置增加不同深度的按压</translation>
    </message>
    <message>
        <source>the presses do not determine every unknown: add presses</source>
        <translation>这些按压不能确定全部未知量：请增加按压</translation>
    </message>
    <message>
        <source>a ball radius of {} mm is impossible</source>
        <translation>球半径不可能是 {} mm</translation>
    </message>
    <message>
        <source>the radius in millimetres, as measured with callipers</source>
        <translation>用卡尺量得的半径，单位毫米</translation>
    </message>
    <message>
        <source>the calibration failed: {}</source>
        <translation>标定失败：{}</translation>
    </message>
    <message>
        <source>fewer presses</source>
        <translation>减少按压</translation>
    </message>
    <message>
        <source>how presses become a mapping: all balls and the mapping in one fit; or, to compare with, every ball from its dark border alone: the source paper&apos;s way, a circle on the face, or the cone of the ball&apos;s outline</source>
        <translation>如何由按压得到映射：所有球与映射一起拟合；或作为比较，每个球只由其暗区边界得出：按原论文、面上的圆，或球轮廓的圆锥</translation>
    </message>
    <message>
        <source>the mapping&apos;s curve; auto: whichever predicts presses left out best</source>
        <translation>映射的曲线；auto：最能预测留出按压的那种</translation>
    </message>
    <message>
        <source>degree of the polynomial; 0: chosen by leaving presses out</source>
        <translation>多项式的次数；0：通过留出按压来选择</translation>
    </message>
    <message>
        <source>which thickness of the layer brightness follows: along z, along its normal, or that along z projected onto the normal; auto: along the normal unless presses left out say otherwise</source>
        <translation>亮度随层的哪种厚度变化：沿 z、沿法线，或沿 z 再投影到法线；auto：沿法线，除非留出的按压另有结论</translation>
    </message>
    <message>
        <source>whether the mapping may vary slowly over the face, for uneven light or an uneven layer; auto: when presses left out agree clearly better then</source>
        <translation>映射是否可在面上缓慢变化，用于光照或层不均匀的情况；auto：当留出的按压因此明显更吻合时</translation>
    </message>
    <message>
        <source>the inner {:.0f} % of each contact&apos;s radius was used, where the skin surely touches the ball</source>
        <translation>使用了每处接触半径的内侧 {} %，那里表皮确实贴着球</translation>
    </message>
    <message>
        <source>the inner {:.0f} % of each contact&apos;s radius was used; the skin comes back from the ball over {:.2f} mm</source>
        <translation>使用了每处接触半径的内侧 {} %；表皮在 {} mm 内离开球面</translation>
    </message>
    <message>
        <source>polynomial of degree {}</source>
        <translation>{} 次多项式</translation>
    </message>
    <message>
        <source>Kubelka-Munk curve</source>
        <translation>Kubelka-Munk 曲线</translation>
    </message>
    <message>
        <source>Moebius curve</source>
        <translation>莫比乌斯曲线</translation>
    </message>
    <message>
        <source>{} that varies over the face</source>
        <translation>在面上变化的{}</translation>
    </message>
    <message>
        <source>its measured depth of {:.3f} +- {:.3f} mm was left out, because the pictures say {:.3f} +- {:.3f} mm; it counts from where the ball first touches, normal to the face</source>
        <translation>其测得的深度 {} +- {} mm 未被采用，因为图像给出 {} +- {} mm；深度从球刚接触处算起，沿面的法线方向</translation>
    </message>
    <message>
        <source>its step of {:.3f} mm was left out, because the balls say {:.3f} +- {:.3f} mm; is the balls&apos; radius right</source>
        <translation>其台阶 {} mm 未被采用，因为各球给出 {} +- {} mm；球的半径是否正确</translation>
    </message>
    <message>
        <source>trying a {}</source>
        <translation>正在尝试：{}</translation>
    </message>
    <message>
        <source>least error on presses left out, {:.4f} mm</source>
        <translation>留出按压的误差最小，{} mm</translation>
    </message>
    <message>
        <source>{:.4f} mm on presses left out, not distinguishable from the best ({}, {:.4f} mm) and simpler</source>
        <translation>留出按压误差 {} mm，与最好的（{}，{} mm）没有区别，而且更简单</translation>
    </message>
    <message>
        <source>with one press nothing can be held out</source>
        <translation>只有一次按压，无法留出</translation>
    </message>
    <message>
        <source>as asked for</source>
        <translation>按要求</translation>
    </message>
    <message>
        <source>the mapping varies over the face, as uneven light or an uneven layer make it: by {:+.0f} % from the presses nearest to the base to those nearest to the tip, by {:+.0f} % from side to side; {:.4f} mm on presses left out, against {:.4f} mm with one mapping for all</source>
        <translation>映射在面上有变化，由光照或层不均匀造成：从最靠近根部到最靠近指尖的按压相差 {} %，两侧之间相差 {} %；留出按压误差 {} mm，全部用同一映射则为 {} mm</translation>
    </message>
    <message>
        <source>no circle goes through the dark border</source>
        <translation>没有圆能通过暗区边界</translation>
    </message>
    <message>
        <source>the circle&apos;s middle lies off the face</source>
        <translation>圆心不在面上</translation>
    </message>
    <message>
        <source>the circle lies off the face</source>
        <translation>圆不在面上</translation>
    </message>
    <message>
        <source>the circle is larger than the ball</source>
        <translation>圆比球大</translation>
    </message>
    <message>
        <source>{:.0f} degrees of the ball&apos;s outline are seen, a cone needs {:.0f}; the rest of the dark border is where the skin leaves the ball</source>
        <translation>看得见球轮廓的 {} 度，圆锥需要 {} 度；其余暗区边界是表皮离开球的地方</translation>
    </message>
    <message>
        <source>no cone touches the outline</source>
        <translation>没有圆锥与轮廓相切</translation>
    </message>
    <message>
        <source>the ball that follows from the dark border hardly touches the face</source>
        <translation>由暗区边界得出的球几乎没有接触面</translation>
    </message>
    <message>
        <source>no ball follows from the dark border of any of {} presses ({})</source>
        <translation>{} 次按压的暗区边界都得不出球（{}）</translation>
    </message>
    <message>
        <source>the joint method, which fits the ball itself</source>
        <translation>使用联合方法，它直接拟合球本身</translation>
    </message>
    <message>
        <source>the polynomial through the balls&apos; depths does not increase</source>
        <translation>通过各球深度的多项式不递增</translation>
    </message>
    <message>
        <source>the joint method, or more presses of different depth</source>
        <translation>使用联合方法，或增加不同深度的按压</translation>
    </message>
    <message>
        <source>the cubic does not increase; degree {} was used instead</source>
        <translation>三次曲线不递增；改用 {} 次</translation>
    </message>
    <message>
        <source>the source paper&apos;s</source>
        <translation>原论文的</translation>
    </message>
    <message>
        <source>{}, in place of the paper&apos;s cubic</source>
        <translation>{}，代替论文的三次曲线</translation>
    </message>
    <message>
        <source>in the middle of the face</source>
        <translation>在面的中线上</translation>
    </message>
    <message>
        <source>{:.0f} mm from the middle on the {} side</source>
        <translation>距中线 {} mm，{}侧</translation>
    </message>
    <message>
        <source>{:.0f} mm from the base, {}</source>
        <translation>距根部 {} mm，{}</translation>
    </message>
    <message>
        <source>least certain is the scale: all depths may be too large or too small together, by {:.3f} mm at {:.2f} mm (one standard deviation)</source>
        <translation>最不确定的是比例：所有深度可能一起偏大或偏小，在 {1} mm 处为 {0} mm（一倍标准差）</translation>
    </message>
    <message>
        <source>least certain is how shallow and deep go together: by {:.3f} mm at {:.2f} mm (one standard deviation), the other way at the other end</source>
        <translation>最不确定的是浅处与深处的关系：在 {1} mm 处为 {0} mm（一倍标准差），另一端相反</translation>
    </message>
    <message>
        <source>smaller</source>
        <translation>偏小</translation>
    </message>
    <message>
        <source>larger</source>
        <translation>偏大</translation>
    </message>
    <message>
        <source>a ball 1 % larger than said makes depths {:.1f} % {}; the residual is {:.4f} mm with a radius 1 % smaller, {:.4f} mm as given, {:.4f} mm with one 1 % larger</source>
        <translation>球若比所给的大 1 %，深度会{1} {0} %；半径小 1 % 时残差为 {2} mm，按所给为 {3} mm，大 1 % 时为 {4} mm</translation>
    </message>
    <message>
        <source>a wrong radius would be noticed</source>
        <translation>半径有误会被发现</translation>
    </message>
    <message>
        <source>the presses cannot show a wrong radius, so measure the ball to a hundredth of a millimetre</source>
        <translation>这些按压显不出半径的错误，请把球量准到百分之一毫米</translation>
    </message>
    <message>
        <source>press next: at another place, 0.5 to 1 mm deep</source>
        <translation>下一次按压：换一处，深 0.5 至 1 mm</translation>
    </message>
    <message>
        <source>press next: {}, {:.1f} mm deep; no press tells whether the mapping holds in that third</source>
        <translation>下一次按压：{}，深 {} mm；还没有按压能说明映射在那三分之一是否成立</translation>
    </message>
    <message>
        <source>enough: one press more would take the standard deviation of depth from {:.4f} mm to {:.4f} mm at best</source>
        <translation>已足够：再按一次最多把深度标准差从 {} mm 降到 {} mm</translation>
    </message>
    <message>
        <source>press next: {}, {:.1f} mm deep; that would take the standard deviation of depth from {:.4f} mm to {:.4f} mm</source>
        <translation>下一次按压：{}，深 {} mm；这会把深度标准差从 {} mm 降到 {} mm</translation>
    </message>
    <message>
        <source>looking for the ball in {}</source>
        <translation>正在 {} 中寻找球</translation>
    </message>
    <message>
        <source>the same picture as {}, counted once</source>
        <translation>与 {} 是同一张图片，只计一次</translation>
    </message>
    <message>
        <source>the contact covers too few pixels</source>
        <translation>接触覆盖的像素太少</translation>
    </message>
    <message>
        <source>pressing the punch in until the skin lies on both of its levels, each 4 mm wide or more</source>
        <translation>压入压头，直到表皮贴住它的两个平面，每个平面至少宽 4 mm</translation>
    </message>
    <message>
        <source>the punch touches too little of the face</source>
        <translation>压头接触到的面太小</translation>
    </message>
    <message>
        <source>no step is to be seen</source>
        <translation>看不到台阶</translation>
    </message>
    <message>
        <source>one of the punch&apos;s levels touches too little of the face</source>
        <translation>压头的一个平面接触到的面太小</translation>
    </message>
    <message>
        <source>along z</source>
        <translation>沿 z</translation>
    </message>
    <message>
        <source>along z projected onto its normal</source>
        <translation>沿 z 并投影到法线</translation>
    </message>
    <message>
        <source>brightness follows the layer&apos;s thickness {}: {:.4f} mm on presses left out, against {:.4f} mm along its normal</source>
        <translation>亮度随层{}的厚度变化：留出按压误差 {} mm，沿法线则为 {} mm</translation>
    </message>
    <message>
        <source>not fit to measure with</source>
        <translation>不适合测量</translation>
    </message>
    <message>
        <source>press again with a clean ball of the radius given, whole on the face</source>
        <translation>请用所给半径的干净球重新按压，使其完全落在面上</translation>
    </message>
    <message>
        <source>unproven</source>
        <translation>未经证实</translation>
    </message>
    <message>
        <source>usable for contact and its place</source>
        <translation>可用于判断接触及其位置</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>dots</source>
        <translation>圆点</translation>
    </message>
    <message>
        <source>inner corners</source>
        <translation>内角点</translation>
    </message>
    <message>
        <source>{} x {} {}</source>
        <translation>{} x {} {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no board; it takes two counts from 3 to 100</source>
        <translation>“{}”不是标定板；需要两个 3 到 100 的数目</translation>
    </message>
    <message>
        <source>9x6 for nine inner corners in a row and six rows</source>
        <translation>9x6 表示每行九个内角点、共六行</translation>
    </message>
    <message>
        <source>the board finder gave up: {}</source>
        <translation>寻找标定板失败：{}</translation>
    </message>
    <message>
        <source>another picture</source>
        <translation>换一张图片</translation>
    </message>
    <message>
        <source>only {} different views of the board are left, {} are needed at least</source>
        <translation>只剩 {} 张不同的标定板视图，至少需要 {} 张</translation>
    </message>
    <message>
        <source>{} pictures or more, with the board tilted and in all parts of the picture</source>
        <translation>{} 张以上的图片，标定板要倾斜并遍及画面各处</translation>
    </message>
    <message>
        <source>shows the board just where {} shows it</source>
        <translation>标定板的位置与 {} 完全相同</translation>
    </message>
    <message>
        <source>no flat board can look so</source>
        <translation>平的标定板不可能呈现这样</translation>
    </message>
    <message>
        <source>stopped before the lens was known</source>
        <translation>得出镜头之前已停止</translation>
    </message>
    <message>
        <source>views that reach into the picture&apos;s corners, or another --model</source>
        <translation>使用到达画面四角的视图，或换一个 --model</translation>
    </message>
    <message>
        <source>leaving views out</source>
        <translation>正在逐一留出视图</translation>
    </message>
    <message>
        <source>comparing halves</source>
        <translation>正在比较两半</translation>
    </message>
    <message>
        <source>with {} coefficients of distortion the lens folds over inside the picture or stays undetermined; {} are used</source>
        <translation>用 {} 个畸变系数时，镜头在画面内折叠或无法确定；改用 {} 个</translation>
    </message>
    <message>
        <source>corners scatter by {:.2f} px; good boards give 0.2 or less: look at focus, motion, and whether the board is flat</source>
        <translation>角点散布 {} px；好的标定板不超过 0.2：请检查对焦、运动以及板是否平整</translation>
    </message>
    <message>
        <source>stopped before everything was judged</source>
        <translation>全部评定之前已停止</translation>
    </message>
    <message>
        <source>What is printed on the board</source>
        <translation>标定板上印的是什么</translation>
    </message>
    <message>
        <source>brown up to about 120 degrees of view, fisheye beyond</source>
        <translation>视角约 120 度以内用 brown，更大用 fisheye</translation>
    </message>
    <message>
        <source>Distance of the finger, at which errors are told in mm</source>
        <translation>手指的距离，误差按此距离以 mm 表示</translation>
    </message>
    <message>
        <source>ChArUco: the markers&apos; family</source>
        <translation>ChArUco：标记的种类</translation>
    </message>
    <message>
        <source>ChArUco: a marker&apos;s side as part of a square&apos;s</source>
        <translation>ChArUco：标记边长占方格边长的比例</translation>
    </message>
    <message>
        <source>all {} views show the board in the same place</source>
        <translation>全部 {} 张视图中标定板都在同一位置</translation>
    </message>
    <message>
        <source>move and tilt the board, or the camera, between pictures</source>
        <translation>每张图片之间移动并倾斜标定板或相机</translation>
    </message>
    <message>
        <source>looking for a first lens</source>
        <translation>正在寻找初始镜头</translation>
    </message>
    <message>
        <source>fitting the lens</source>
        <translation>正在拟合镜头</translation>
    </message>
    <message>
        <source>no {} with {} can be seen</source>
        <translation>看不到{}({})</translation>
    </message>
    <message>
        <source>the picture has hardly any contrast</source>
        <translation>图片几乎没有对比度</translation>
    </message>
    <message>
        <source>more light, and the board in focus</source>
        <translation>增加光照，并使标定板清晰</translation>
    </message>
    <message>
        <source>a large part of the picture is white without detail</source>
        <translation>图片大部分是没有细节的白色</translation>
    </message>
    <message>
        <source>a shorter exposure</source>
        <translation>缩短曝光</translation>
    </message>
    <message>
        <source>the whole board in the picture, with its white border, sharp and evenly lit</source>
        <translation>整块标定板连同白边都在画面内，清晰且光照均匀</translation>
    </message>
    <message>
        <source>chessboard</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco 板</translation>
    </message>
    <message>
        <source>not one of its markers</source>
        <translation>一个标记也看不到</translation>
    </message>
    <message>
        <source>only {} of the ChArUco board&apos;s corners can be seen, {} are needed</source>
        <translation>只看到 ChArUco 板的 {} 个角点，需要 {} 个</translation>
    </message>
    <message>
        <source>more of the board in the picture, sharp and evenly lit</source>
        <translation>让更多标定板进入画面，清晰且光照均匀</translation>
    </message>
    <message>
        <source>only corners in one line of the ChArUco board can be seen</source>
        <translation>只看到 ChArUco 板上同一直线的角点</translation>
    </message>
    <message>
        <source>more of the board in the picture</source>
        <translation>让更多标定板进入画面</translation>
    </message>
    <message>
        <source>dot grid</source>
        <translation>圆点阵列</translation>
    </message>
    <message>
        <source>a dot of the grid lies at the picture&apos;s border or has no contrast</source>
        <translation>阵列中有圆点位于画面边缘或没有对比度</translation>
    </message>
    <message>
        <source>the whole board in the picture, evenly lit</source>
        <translation>整块标定板在画面内，光照均匀</translation>
    </message>
    <message>
        <source>top left corner</source>
        <translation>左上角</translation>
    </message>
    <message>
        <source>top edge</source>
        <translation>上边</translation>
    </message>
    <message>
        <source>top right corner</source>
        <translation>右上角</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>左边</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中部</translation>
    </message>
    <message>
        <source>right edge</source>
        <translation>右边</translation>
    </message>
    <message>
        <source>bottom left corner</source>
        <translation>左下角</translation>
    </message>
    <message>
        <source>bottom edge</source>
        <translation>下边</translation>
    </message>
    <message>
        <source>bottom right corner</source>
        <translation>右下角</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} 和 {}</translation>
    </message>
    <message>
        <source>one</source>
        <translation>一</translation>
    </message>
    <message>
        <source>two</source>
        <translation>两</translation>
    </message>
    <message>
        <source>three</source>
        <translation>三</translation>
    </message>
    <message>
        <source>four</source>
        <translation>四</translation>
    </message>
    <message>
        <source>five</source>
        <translation>五</translation>
    </message>
    <message>
        <source>six</source>
        <translation>六</translation>
    </message>
    <message>
        <source>seven</source>
        <translation>七</translation>
    </message>
    <message>
        <source>eight</source>
        <translation>八</translation>
    </message>
    <message>
        <source>nine</source>
        <translation>九</translation>
    </message>
    <message>
        <source>ten</source>
        <translation>十</translation>
    </message>
    <message>
        <source>{} more, tilted {}</source>
        <translation>再{}张，向{}倾斜</translation>
    </message>
    <message>
        <source>{} more, tilted</source>
        <translation>再{}张，要倾斜</translation>
    </message>
    <message>
        <source>large enough to fill the picture</source>
        <translation>大到充满画面</translation>
    </message>
    <message>
        <source>near the {}</source>
        <translation>靠近{}</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>down</source>
        <translation>下</translation>
    </message>
    <message>
        <source>these views leave the lens undetermined</source>
        <translation>这些视图不足以确定镜头</translation>
    </message>
    <message>
        <source>more views, with the board tilted by 20 to 40 degrees in different directions</source>
        <translation>增加视图，标定板向不同方向倾斜 20 到 40 度</translation>
    </message>
    <message>
        <source>no lens could be fitted to the corners that were found</source>
        <translation>无法对找到的角点拟合出镜头</translation>
    </message>
    <message>
        <source>a flat board of the size given with --board, and views that show it tilted</source>
        <translation>使用与 --board 尺寸相符的平板，并有倾斜的视图</translation>
    </message>
    <message>
        <source>no lens explains the corners that were found</source>
        <translation>没有镜头能解释找到的角点</translation>
    </message>
    <message>
        <source>a flat board of the size given with --board; --model fisheye for a lens wider than 120 degrees</source>
        <translation>使用与 --board 尺寸相符的平板；视角大于 120 度的镜头用 --model fisheye</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>可用</translation>
    </message>
    <message>
        <source>the focal length is known to {:.2g} %, {:.2g} mm at {:g} mm</source>
        <translation>焦距的不确定度为 {0} %，在 {2} mm 处为 {1} mm</translation>
    </message>
    <message>
        <source>but two halves of the views disagree by {:.2f} px ({:.2g} mm)</source>
        <translation>但两半视图相差 {} px({} mm)</translation>
    </message>
    <message>
        <source>but views left out fit worse ({:.2f} px) than those fitted ({:.2f} px)</source>
        <translation>但留出的视图（{} px）不如参与拟合的（{} px）吻合</translation>
    </message>
    <message>
        <source>but the views do not cover the picture and the tilts it needs</source>
        <translation>但视图没有覆盖画面和所需的倾斜</translation>
    </message>
    <message>
        <source>with so few views none could be left out to show what it is worth</source>
        <translation>视图太少，无法留出任何一张来检验</translation>
    </message>
    <message>
        <source>take {}</source>
        <translation>请拍摄{}</translation>
    </message>
    <message>
        <source>add views, sharp and tilted, that fill the picture</source>
        <translation>请增加清晰、倾斜且充满画面的视图</translation>
    </message>
    <message>
        <source>no board was found in any of {} pictures</source>
        <translation>{} 张图片中都没有找到标定板</translation>
    </message>
    <message>
        <source>{} (the first: {})</source>
        <translation>{}（第一张：{}）</translation>
    </message>
    <message>
        <source>no board with {} was found, but one with {}</source>
        <translation>没有找到{}的标定板，但找到了 {} 的</translation>
    </message>
    <message>
        <source>--board with {}: inner corners are counted, not squares</source>
        <translation>--board 用 {}：数的是内角点，不是方格</translation>
    </message>
    <message>
        <source>--board and --pattern as the board is, and the whole board in the picture</source>
        <translation>--board 和 --pattern 与标定板一致，且整块板在画面内</translation>
    </message>
    <message>
        <source>stopped while looking for boards; nothing was written</source>
        <translation>寻找标定板时已停止；没有写出任何内容</translation>
    </message>
    <message>
        <source>looking for the board in {}</source>
        <translation>正在 {} 中寻找标定板</translation>
    </message>
    <message>
        <source>is {} x {} px, the pictures before it {} x {}</source>
        <translation>为 {} x {} px，之前的图片为 {} x {}</translation>
    </message>
    <message>
        <source>pictures of one camera in one mode; a lens differs with the picture&apos;s size</source>
        <translation>使用同一相机同一模式的图片；镜头随图片尺寸而不同</translation>
    </message>
    <message>
        <source>another picture is called &apos;{}&apos; as well</source>
        <translation>另一张图片也叫“{}”</translation>
    </message>
    <message>
        <source>giving the pictures different names</source>
        <translation>给图片取不同的名字</translation>
    </message>
    <message>
        <source>its corners lie {:.2f} px from where the lens sees them, those of the others {:.2f} px</source>
        <translation>它的角点偏离镜头所见 {} px，其他的为 {} px</translation>
    </message>
    <message>
        <source>blurred, by motion or focus: its edges are {:.1f} px wide, those of the others {:.1f} px</source>
        <translation>因运动或失焦而模糊：边缘宽 {} px，其他的为 {} px</translation>
    </message>
    <message>
        <source>the board is bent in it, glue it to something stiff</source>
        <translation>图中标定板弯曲了，请把它贴在硬物上</translation>
    </message>
    <message>
        <source>{} of its {} corners lie elsewhere: covered, mirrored in something, or blurred</source>
        <translation>{1} 个角点中有 {0} 个不在应在之处：被遮挡、反光或模糊</translation>
    </message>
    <message>
        <source>moved during the exposure, or not this board</source>
        <translation>曝光时有移动，或不是这块板</translation>
    </message>
    <message>
        <source>its squares are {:.2f} % {} than they are high</source>
        <translation>方格的宽比高{1} {0} %</translation>
    </message>
    <message>
        <source>wider</source>
        <translation>大</translation>
    </message>
    <message>
        <source>narrower</source>
        <translation>小</translation>
    </message>
    <message>
        <source>it is bent by about {:.2g} mm from its middle to its corners</source>
        <translation>从中央到四角弯曲约 {} mm</translation>
    </message>
    <message>
        <source>{}, and {}</source>
        <translation>{}，而且 {}</translation>
    </message>
    <message>
        <source>the board is not the flat, even one it is taken for: {}; with that allowed for fx would be {:.2f} instead of {:.2f} px; use a board on glass or metal</source>
        <translation>标定板不像假定的那样平整均匀：{}；考虑到这一点，fx 应为 {} 而不是 {} px；请使用玻璃或金属上的标定板</translation>
    </message>
    <message>
        <source>hardly any pixel of the face could be compared with the reference</source>
        <translation>面上几乎没有像素能与参考比较</translation>
    </message>
    <message>
        <source>a press and a reference of the same size in which the face is lit</source>
        <translation>使用尺寸相同、面已照亮的按压图片和参考</translation>
    </message>
    <message>
        <source>nothing on the face is clearly darker than in the reference (the darkest part differs by {:.1f} %, the rest scatters by {:.1f} %)</source>
        <translation>面上没有明显比参考更暗的地方（最暗处相差 {} %，其余散布 {} %）</translation>
    </message>
    <message>
        <source>pressing the ball in deeper, and checking that the reference shows the same finger in the same pose</source>
        <translation>把球压得更深，并检查参考是否为同一手指的同一姿态</translation>
    </message>
    <message>
        <source>only specks are dark, none larger than {} pixels</source>
        <translation>只有斑点是暗的，没有一个大于 {} 像素</translation>
    </message>
    <message>
        <source>pressing the ball in deeper</source>
        <translation>把球压得更深</translation>
    </message>
    <message>
        <source>two contacts were found, the second with {:.0f} % of the first</source>
        <translation>找到两处接触，第二处为第一处的 {} %</translation>
    </message>
    <message>
        <source>a press in which only the ball touches the face</source>
        <translation>只有球接触面的按压</translation>
    </message>
    <message>
        <source>the border of the dark part is no arc of a circle</source>
        <translation>暗区的边界不是圆弧</translation>
    </message>
    <message>
        <source>a press in which the ball lies wholly on the face</source>
        <translation>球完全落在面上的按压</translation>
    </message>
    <message>
        <source>only {:.0f} degrees of the dark disc&apos;s rim lie on the face</source>
        <translation>暗斑的边缘只有 {} 度在面上</translation>
    </message>
    <message>
        <source>a press nearer to the middle of the face</source>
        <translation>更靠近面中央的按压</translation>
    </message>
    <message>
        <source>the dark part has a radius of {:.2f} mm, more than the ball&apos;s {:g} mm</source>
        <translation>暗区半径为 {} mm，大于球的 {} mm</translation>
    </message>
    <message>
        <source>checking the ball&apos;s radius, or a picture in which only the ball touches</source>
        <translation>检查球的半径，或使用只有球接触的图片</translation>
    </message>
    <message>
        <source>the dark part is no disc: its rim is off a circle by {:.0f} % of the radius, and {:.0f} % of the circle is dark</source>
        <translation>暗区不是圆盘：边缘偏离圆达半径的 {} %，圆内有 {} % 是暗的</translation>
    </message>
    <message>
        <source>a picture in which a ball, and only the ball, touches the face</source>
        <translation>只有一个球接触面的图片</translation>
    </message>
    <message>
        <source>the middle of the dark disc lies off the face</source>
        <translation>暗斑的中心不在面上</translation>
    </message>
    <message>
        <source>the press has no difference picture</source>
        <translation>该按压没有差值图</translation>
    </message>
    <message>
        <source>taking the picture again</source>
        <translation>重新拍摄图片</translation>
    </message>
    <message>
        <source>OpenCV failed: {}</source>
        <translation>OpenCV 出错：{}</translation>
    </message>
    <message>
        <source>the finger moves: no more than {} of {} frames in a row show the same</source>
        <translation>手指在动：{1} 帧中连续相同的不超过 {0} 帧</translation>
    </message>
    <message>
        <source>holding ball and finger still for half a second, at a steady light</source>
        <translation>在稳定的光照下使球和手指保持静止半秒</translation>
    </message>
    <message>
        <source>the mean of {} frames held still, of {} read</source>
        <translation>读取的 {1} 帧中 {0} 帧静止画面的平均</translation>
    </message>
    <message>
        <source>the ball that was put there by hand does not touch the face</source>
        <translation>手动放置的球没有接触面</translation>
    </message>
    <message>
        <source>moving its outline onto the dark disc, or having the ball found</source>
        <translation>把轮廓移到暗斑上，或让程序寻找球</translation>
    </message>
    <message>
        <source>one for each press, &quot;&quot; where there is nothing to say</source>
        <translation>每次按压一个，没有内容处写 &quot;&quot;</translation>
    </message>
    <message>
        <source>is not the centre of a ball before the camera</source>
        <translation>不是相机前方的球心</translation>
    </message>
    <message>
        <source>x, y, z in mm</source>
        <translation>x、y、z，单位 mm</translation>
    </message>
    <message>
        <source>must hold two numbers for each press</source>
        <translation>每次按压必须有两个数</translation>
    </message>
    <message>
        <source>a depth and its standard deviation in mm</source>
        <translation>一个深度及其标准差，单位 mm</translation>
    </message>
    <message>
        <source>frame {}</source>
        <translation>第 {} 帧</translation>
    </message>
    <message>
        <source>only {} of {} frames can be used ({})</source>
        <translation>{1} 帧中只有 {0} 帧可用（{2}）</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>录像</translation>
    </message>
    <message>
        <source>record again with every marker in view and nothing on the contact face</source>
        <translation>重新录制，所有标记点都在画面内，接触面上没有东西</translation>
    </message>
    <message>
        <source>the recording has no such frame</source>
        <translation>录像中没有这一帧</translation>
    </message>
    <message>
        <source>frame {} cannot be the finger&apos;s rest: {}</source>
        <translation>第 {} 帧不能作为手指的静止姿态：{}</translation>
    </message>
    <message>
        <source>another frame in which the finger rests</source>
        <translation>另一帧手指静止的画面</translation>
    </message>
    <message>
        <source>frame {}: something pressed on the contact face, {:.0f} mm from its base ({:.0f} % darker than untouched)</source>
        <translation>第 {} 帧：接触面受压，距根部 {} mm（比未触碰时暗 {} %）</translation>
    </message>
    <message>
        <source>frames {} to {}: something may have pressed on the contact face, {:.0f} mm from its base (up to {:.1f} % darker than untouched)</source>
        <translation>第 {} 至 {} 帧：接触面上可能有物体按压，距根部 {} mm（比未接触时最多暗 {} %）</translation>
    </message>
    <message>
        <source>frames {} to {}: something pressed on the contact face, {:.0f} mm from its base (up to {:.0f} % darker than untouched)</source>
        <translation>第 {} 至 {} 帧：有物体按压接触面，距根部 {} mm（比未接触时最多暗 {} %）</translation>
    </message>
    <message>
        <source>In {} of {} frames the face is darker than in the others: something pressed on it most of the time, or most poses were shown once. All frames stay in; if anything touched the face, record again, and show each pose several times</source>
        <translation>{}/{} 帧中，表面比其余帧更暗：要么大部分时间有物体按压，要么大多数姿态只出现过一次。所有帧都保留；如果有物体碰到表面，请重新录制，并让每个姿态出现多次</translation>
    </message>
    <message>
        <source>In {} of {} frames the face is darker than in the brightest, and so are frames of near poses: something pressed on it for long, or these poses were shown once. They stay in; if anything touched the face, record again, and show each pose several times</source>
        <translation>在 {} / {} 帧中接触面比最亮的帧暗，姿态相近的帧也是如此：有物体长时间按压，或这些姿态只出现过一次。这些帧予以保留；如果有物体碰过接触面，请重新录制，并让每个姿态出现多次</translation>
    </message>
    <message>
        <source>only {} frames are left of those that are to be used</source>
        <translation>可用的帧只剩 {} 帧</translation>
    </message>
    <message>
        <source>leave out fewer frames</source>
        <translation>请少排除一些帧</translation>
    </message>
    <message>
        <source>the face is {:.0f} % brighter than its reference {:.0f} mm from the base: something pressed there when the reference was recorded, near its frame {}; record the reference again</source>
        <translation>接触面比参考亮 {} %（距根部 {} mm）：录制参考时该处有物体按压，在其第 {} 帧附近；请重新录制参考</translation>
    </message>
    <message>
        <source>record again with nothing on the contact face, or say that its skin was changed since</source>
        <translation>在接触面上没有任何物体时重新录制，或说明其表皮此后已改变</translation>
    </message>
    <message>
        <source>something pressed on the contact face {:.0f} mm from its base in {} of {} frames: it is {:.0f} % darker there than in the reference from before</source>
        <translation>接触面距根部 {} mm 处在 {} / {} 帧中有物体按压：该处比先前的参考暗 {} %</translation>
    </message>
    <message>
        <source>in {} of {} presses the face is brighter than its reference {:.0f} mm along it: something pressed there when the reference was recorded; record it again, then calibrate again</source>
        <translation>{} / {} 次按压中，接触面在沿其 {} mm 处比参考更亮：录制参考时该处有物体按压；请重新录制，然后重新标定</translation>
    </message>
    <message>
        <source>{} frames show poses that no other frame shows at another time; whether something pressed on the contact face in them is not known</source>
        <translation>{} 帧的姿态在其他时刻没有出现过；无法得知其中接触面上是否有物体按压</translation>
    </message>
    <message>
        <source>No markers can be used: {}; poses are told by the shape of the face alone, which cannot tell twist; if the finger has dots, light both side faces so that they stand out, and focus</source>
        <translation>没有可用的标记点：{}。姿态仅由面的形状判断，无法判断扭转；若手指有标记点，请照亮两个侧面使其突出，并对好焦</translation>
    </message>
    <message>
        <source>Markers {} were not found anywhere; the finger works with the other {}</source>
        <translation>未找到标记点 {}；手指使用其余 {} 个</translation>
    </message>
    <message numerus="yes">
        <source>the recording holds {} frames; at least 2 are needed</source>
        <comment>the recording holds {} frame; at least 2 are needed</comment>
        <translation>
            <numerusform>录像只有 {} 帧；至少需要 2 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>record the finger while it bends slowly in every direction, untouched</source>
        <translation>录制手指未触碰时缓慢向各个方向弯曲的过程</translation>
    </message>
    <message>
        <source>numbering the markers</source>
        <translation>正在给标记点编号</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>{:.1f} of {:.1f} {} reached</source>
        <translation>已达到 {} / {} {}</translation>
    </message>
    <message>
        <source>bend it further away from the camera</source>
        <translation>向远离相机的方向再弯一些</translation>
    </message>
    <message>
        <source>bend it further towards the camera</source>
        <translation>向靠近相机的方向再弯一些</translation>
    </message>
    <message>
        <source>push its tip further to one side</source>
        <translation>把指尖再向一侧推</translation>
    </message>
    <message>
        <source>push its tip further to the other side</source>
        <translation>把指尖再向另一侧推</translation>
    </message>
    <message>
        <source>twist it further one way</source>
        <translation>再向一个方向扭</translation>
    </message>
    <message>
        <source>twist it further the other way</source>
        <translation>再向另一方向扭</translation>
    </message>
    <message>
        <source>bend it while its tip is pushed aside: {:.0f} % of the combinations were seen</source>
        <translation>把指尖推向一侧的同时弯曲：已看到 {} % 的组合</translation>
    </message>
    <message>
        <source>a frame shows {} dots on the upper and {} on the lower side face (median of {} frames), but no two rows of up to {} that keep their places on the finger</source>
        <translation>一帧中上侧面有 {} 个点、下侧面有 {} 个点（{} 帧的中位数），但没有两排各至多 {} 个在手指上位置不变的点</translation>
    </message>
    <message>
        <source>{} dots were found but they fit no pose of the {} markers</source>
        <translation>找到 {} 个点，但与 {} 个标记点的任何姿态都不符</translation>
    </message>
    <message>
        <source>only {} of {} markers found</source>
        <translation>只找到 {} 个标记点（共 {} 个）</translation>
    </message>
    <message>
        <source>the markers lie {:.1f} px from where they can be</source>
        <translation>标记点偏离可能的位置 {} px</translation>
    </message>
    <message>
        <source>of {} markers none may be hidden</source>
        <translation>仅有 {} 个标记点，一个都不能被遮挡</translation>
    </message>
    <message>
        <source>no frame shows the face</source>
        <translation>没有一帧显示面</translation>
    </message>
    <message>
        <source>a recording in which both long edges of the bright face are visible</source>
        <translation>能看见明亮面两条长边的录像</translation>
    </message>
    <message>
        <source>stopped before the recording was read</source>
        <translation>读完录像之前已停止</translation>
    </message>
    <message>
        <source>reading frame {} of {}</source>
        <translation>正在读取第 {} / {} 帧</translation>
    </message>
    <message>
        <source>a recording made with this finger&apos;s camera, or the right camera.size and orientation</source>
        <translation>用此手指的相机录制，或改正 camera.size 和 orientation</translation>
    </message>
    <message>
        <source>the recording cannot be renamed: {}</source>
        <translation>无法重命名录像：{}</translation>
    </message>
    <message>
        <source>stopped before the recording was written</source>
        <translation>写完录像之前已停止</translation>
    </message>
    <message>
        <source>writing the frames that are kept</source>
        <translation>正在写入保留的帧</translation>
    </message>
    <message>
        <source>stopped before the recording was compared</source>
        <translation>比较完录像之前已停止</translation>
    </message>
    <message>
        <source>comparing frame {} of {}</source>
        <translation>正在比较第 {} / {} 帧</translation>
    </message>
    <message>
        <source>{} marker positions in {} frames are estimates, because the markers were covered or not found</source>
        <translation>{1} 帧中有 {0} 个标记点位置是估计值，因为标记点被遮挡或未找到</translation>
    </message>
    <message>
        <source>{} frames are few: a recording of a minute (about 1500 frames) over all directions of bending gives closer references</source>
        <translation>{} 帧偏少：录制一分钟（约 1500 帧）并覆盖所有弯曲方向，可得到更接近的参考</translation>
    </message>
    <message>
        <source>Not yet seen: {}</source>
        <translation>尚未看到：{}</translation>
    </message>
    <message>
        <source>this finger has no markers to record a reference with</source>
        <translation>此手指没有标记点，无法录制参考</translation>
    </message>
    <message>
        <source>a flat sensor takes one untouched picture</source>
        <translation>平面传感器使用一张未接触的图像</translation>
    </message>
    <message>
        <source>the recording could not be processed ({})</source>
        <translation>无法处理录像（{}）</translation>
    </message>
    <message>
        <source>reference installed</source>
        <translation>参考已设置</translation>
    </message>
    <message>
        <source>only a flat sensor takes one untouched picture as its reference</source>
        <translation>只有平面传感器以一张未触碰的图片为参考</translation>
    </message>
    <message>
        <source>a recording of the bending, untouched finger</source>
        <translation>使用未触碰手指弯曲的录像</translation>
    </message>
    <message>
        <source>an untouched picture taken with this sensor&apos;s camera</source>
        <translation>用此传感器的相机拍摄的未触碰图片</translation>
    </message>
    <message>
        <source>presses</source>
        <translation>按压</translation>
    </message>
    <message>
        <source>set of presses</source>
        <translation>这组按压</translation>
    </message>
    <message>
        <source>The {} was not taken with one setting of camera and light: {}. Lock them, and record it again.</source>
        <translation>{}不是在同一相机和灯光设置下拍摄的：{}。请锁定设置后重新录制。</translation>
    </message>
    <message>
        <source>The {} and the {} were taken with other settings: {}. Depth comes from comparing their brightness: record one of them again.</source>
        <translation>{}与{}的拍摄设置不同：{}。深度来自两者亮度的比较：请重新录制其中之一。</translation>
    </message>
    <message>
        <source>The finger was calibrated with other settings: {}. Set them as they were, or calibrate again.</source>
        <translation>手指是在不同的设置下标定的：{}。请恢复当时的设置，或重新标定。</translation>
    </message>
    <message>
        <source>the brightness of the untouched face changes from press to press (standard deviation {:.1f} %): exposure or gain is automatic, or the room&apos;s light gets in; lock them, shade the finger and press again</source>
        <translation>未触碰处的亮度随每次按压而变（标准差 {} %）：曝光或增益为自动，或有环境光进入；请锁定它们，给手指遮光后重新按压</translation>
    </message>
    <message>
        <source>the untouched face is {:.1f} % {} in all presses than in the reference: the light, the exposure or the gain has changed between them; depth is corrected for it as far as it is smooth, but let the lamps warm up and record the reference again</source>
        <translation>所有按压中未触碰处都比参考{1} {0} %：其间光照、曝光或增益有变；深度已对平缓的部分作了校正，但请让灯预热后重新录制参考</translation>
    </message>
    <message>
        <source>in {} of {} presses the finger is bent in a way that the reference recording does not hold, or it has moved in its mount since: record a reference that bends as far, or press with less bending</source>
        <translation>{1} 次按压中有 {0} 次手指的弯曲在参考录像中没有，或其后手指在安装座中移动了：请录制弯曲同样大的参考，或按压时少弯曲</translation>
    </message>
    <message>
        <source>no mapping came of it</source>
        <translation>没有得到映射</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>base</source>
        <translation>根部</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>指尖</translation>
    </message>
    <message>
        <source>upper half</source>
        <translation>上半</translation>
    </message>
    <message>
        <source>lower half</source>
        <translation>下半</translation>
    </message>
    <message numerus="yes">
        <source>{1} {2:.3f} mm ({0} presses)</source>
        <comment>{1} {2:.3f} mm ({0} press)</comment>
        <translation>
            <numerusform>{1} {2} mm（{0} 次按压）</numerusform>
        </translation>
    </message>
    <message>
        <source>{} unknown: no press there</source>
        <translation>{}未知：那里没有按压</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>results and truth are of different size</source>
        <translation>结果与真值的尺寸不同</translation>
    </message>
    <message>
        <source>not as `alltact simulate` and `alltact reconstruct` write it ({})</source>
        <translation>与 `alltact simulate` 和 `alltact reconstruct` 写出的不同（{}）</translation>
    </message>
    <message>
        <source>{} with {}</source>
        <translation>{} 与 {}</translation>
    </message>
    <message>
        <source>running both again</source>
        <translation>重新运行这两个命令</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>the press could not be removed: {}</source>
        <translation>无法移除按压：{}</translation>
    </message>
    <message>
        <source>no finger is open, so the recording cannot be measured</source>
        <translation>没有打开手指，无法测量录像</translation>
    </message>
    <message>
        <source>opening a finger</source>
        <translation>打开手指</translation>
    </message>
    <message>
        <source>this recording is not there any more</source>
        <translation>这段录像已不存在</translation>
    </message>
    <message>
        <source>plugging in the disk it lies on, or opening another one</source>
        <translation>插上存放它的磁盘，或打开另一段录像</translation>
    </message>
    <message>
        <source>there is no face to save</source>
        <translation>没有可保存的面</translation>
    </message>
    <message>
        <source>another frame</source>
        <translation>换一帧</translation>
    </message>
    <message>
        <source>frame {} of {}</source>
        <translation>第 {} / {} 帧</translation>
    </message>
    <message>
        <source>the finger that belongs to this camera, or this finger&apos;s camera</source>
        <translation>打开属于此相机的手指，或使用此手指的相机</translation>
    </message>
    <message>
        <source>there is no HID device that can be read</source>
        <translation>没有可以读取的 HID 设备</translation>
    </message>
    <message>
        <source>plugging in a pedal</source>
        <translation>插上脚踏开关</translation>
    </message>
    <message>
        <source>stopped before the report was written</source>
        <translation>报告写完之前已停止</translation>
    </message>
    <message>
        <source>the report could not be printed</source>
        <translation>无法生成报告的打印版</translation>
    </message>
    <message>
        <source>this computer cannot draw in 3D: there is no EGL with OpenGL 3.2</source>
        <translation>本机无法绘制三维图：没有支持 OpenGL 3.2 的 EGL</translation>
    </message>
    <message>
        <source>installing libegl1 and libgl1-mesa-dri, which draw in software</source>
        <translation>安装 libegl1 和 libgl1-mesa-dri，它们用软件绘制</translation>
    </message>
    <message>
        <source>this is not a session of this program</source>
        <translation>这不是本程序的会话</translation>
    </message>
    <message>
        <source>beginning a new one</source>
        <translation>开始新的会话</translation>
    </message>
    <message>
        <source>there is no lamp whose light could be absorbed</source>
        <translation>没有光可被吸收的灯</translation>
    </message>
    <message>
        <source>name the effect leds too</source>
        <translation>同时写上效果 leds</translation>
    </message>
    <message>
        <source>room light comes on top of that of the lamps</source>
        <translation>室内光叠加在灯光之上</translation>
    </message>
    <message>
        <source>there is no lamp that could fail</source>
        <translation>没有可能失效的灯</translation>
    </message>
    <message>
        <source>there is no lamp {}</source>
        <translation>没有编号为 {} 的灯</translation>
    </message>
    <message>
        <source>there is no lamp that could flicker</source>
        <translation>没有可能闪烁的灯</translation>
    </message>
    <message>
        <source>there is no lamp that could warm up</source>
        <translation>没有会升温的灯</translation>
    </message>
    <message>
        <source>no light would be left within the picture</source>
        <translation>图像内会有地方完全没有光</translation>
    </message>
    <message>
        <source>1 + a r^2 + b r^4 + c r^6 above 0 up to r = 1</source>
        <translation>直到 r = 1，1 + a r^2 + b r^4 + c r^6 都大于 0</translation>
    </message>
    <message>
        <source>the rays of an orthographic camera do not spread</source>
        <translation>正交相机的光线不发散</translation>
    </message>
    <message>
        <source>kind: polynomial, or leave vignetting out</source>
        <translation>kind: polynomial，或去掉 vignetting</translation>
    </message>
    <message>
        <source>gamma 1 changes nothing</source>
        <translation>gamma 为 1 不起作用</translation>
    </message>
    <message>
        <source>leave gamma out</source>
        <translation>去掉 gamma</translation>
    </message>
    <message>
        <source>there is neither dead nor hot</source>
        <translation>既没有 dead 也没有 hot</translation>
    </message>
    <message>
        <source>name one of them</source>
        <translation>写上其中一个</translation>
    </message>
    <message>
        <source>there is neither prnu nor dsnu</source>
        <translation>既没有 prnu 也没有 dsnu</translation>
    </message>
    <message>
        <source>the exposure could not change</source>
        <translation>曝光无法变化</translation>
    </message>
    <message>
        <source>more than 1</source>
        <translation>大于 1</translation>
    </message>
    <message>
        <source>an orthographic camera has no focal length to blur by</source>
        <translation>正交相机没有造成模糊的焦距</translation>
    </message>
    <message>
        <source>the shutter would be open for longer than a frame lasts</source>
        <translation>快门打开的时间会超过一帧的时长</translation>
    </message>
    <message>
        <source>exposure_ms up to {:g}</source>
        <translation>exposure_ms 不超过 {:g}</translation>
    </message>
    <message>
        <source>reading the rows would take longer than a frame lasts</source>
        <translation>读出各行所需的时间会超过一帧的时长</translation>
    </message>
    <message>
        <source>readout_ms up to {:g}</source>
        <translation>readout_ms 不超过 {:g}</translation>
    </message>
    <message>
        <source>there are no dots to wear off</source>
        <translation>没有可磨损的点</translation>
    </message>
    <message>
        <source>stopped before all effects were measured</source>
        <translation>在测完所有效果之前已停止</translation>
    </message>
    <message>
        <source>measuring {}</source>
        <translation>正在测量 {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not of the form {}</source>
        <translation>&apos;{}&apos; 不符合 {} 的形式</translation>
    </message>
    <message>
        <source>there is no layer for the bubble to be in</source>
        <translation>没有可容纳气泡的层</translation>
    </message>
    <message>
        <source>name the effect layer too</source>
        <translation>同时写上效果 layer</translation>
    </message>
    <message>
        <source>the bubble is wider than the layer is thick</source>
        <translation>气泡的直径大于层的厚度</translation>
    </message>
    <message>
        <source>radius_mm up to {:g}</source>
        <translation>radius_mm 不超过 {:g}</translation>
    </message>
    <message>
        <source>The finger&apos;s faces light each other</source>
        <translation>手指的各个面互相照亮</translation>
    </message>
    <message>
        <source>the faces that light each other are the lit view face and side faces</source>
        <translation>互相照亮的是被照亮的视面和侧面</translation>
    </message>
    <message>
        <source>name the effects sides and leds too</source>
        <translation>也请写出效果 sides 和 leds</translation>
    </message>
    <message>
        <source>The silicone absorbs light on its way</source>
        <translation>硅胶在光路上吸收光</translation>
    </message>
    <message>
        <source>Light of the room falls on the faces</source>
        <translation>环境光照在各表面上</translation>
    </message>
    <message>
        <source>The camera exposes by itself, by how bright the picture is</source>
        <translation>相机按画面亮度自动曝光</translation>
    </message>
    <message>
        <source>The sensor adds a constant to every pixel</source>
        <translation>传感器给每个像素加上一个常数</translation>
    </message>
    <message>
        <source>A bubble of air makes the layer thinner</source>
        <translation>气泡使层变薄</translation>
    </message>
    <message>
        <source>A lamp is off</source>
        <translation>一盏灯不亮</translation>
    </message>
    <message>
        <source>Single pixels are always dark or always bright</source>
        <translation>个别像素始终暗或始终亮</translation>
    </message>
    <message>
        <source>What is not at the distance of sharp focus is blurred</source>
        <translation>不在对焦距离上的部分变得模糊</translation>
    </message>
    <message>
        <source>Every pixel is a little brighter or darker than its neighbours, always the same way</source>
        <translation>每个像素总是比相邻像素略亮或略暗</translation>
    </message>
    <message>
        <source>The lamps flicker</source>
        <translation>灯光闪烁</translation>
    </message>
    <message>
        <source>The camera&apos;s gain drifts from frame to frame</source>
        <translation>相机增益逐帧漂移</translation>
    </message>
    <message>
        <source>The camera bends its grey levels by a power law</source>
        <translation>相机按幂律改变灰度</translation>
    </message>
    <message>
        <source>A lamp mirrors in the face</source>
        <translation>灯在表面上形成反光</translation>
    </message>
    <message>
        <source>The coat has a hole through which light comes</source>
        <translation>涂层有一个透光的孔</translation>
    </message>
    <message>
        <source>Stray light falls on the sensor</source>
        <translation>杂散光落在传感器上</translation>
    </message>
    <message>
        <source>The finger moves while a picture is exposed</source>
        <translation>曝光期间手指在运动</translation>
    </message>
    <message>
        <source>The rows of a picture are taken one after the other</source>
        <translation>图像各行依次曝光</translation>
    </message>
    <message>
        <source>Every row is a little brighter or darker, differently in each frame</source>
        <translation>每行略亮或略暗，每帧不同</translation>
    </message>
    <message>
        <source>A scratch crosses the face</source>
        <translation>一条划痕穿过表面</translation>
    </message>
    <message>
        <source>A speck of dirt lies on the face</source>
        <translation>表面上有一个污点</translation>
    </message>
    <message>
        <source>The layer is not equally thick everywhere</source>
        <translation>层的厚度不均匀</translation>
    </message>
    <message>
        <source>Part of the light spreads over the whole picture</source>
        <translation>部分光散布到整幅图像</translation>
    </message>
    <message>
        <source>The picture is darker towards its corners</source>
        <translation>图像向四角变暗</translation>
    </message>
    <message>
        <source>The lamps lose light while they warm up</source>
        <translation>灯在升温时亮度下降</translation>
    </message>
    <message>
        <source>Dots are worn and fainter</source>
        <translation>标记点磨损而变淡</translation>
    </message>
    <message>
        <source>a point of the mesh is no number</source>
        <translation>网格中有一个点不是数</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>重新导出</translation>
    </message>
    <message>
        <source>there is no such mesh</source>
        <translation>没有这个网格</translation>
    </message>
    <message>
        <source>an STL or OBJ file</source>
        <translation>STL 或 OBJ 文件</translation>
    </message>
    <message>
        <source>this is not known as a mesh</source>
        <translation>这不是已知的网格格式</translation>
    </message>
    <message>
        <source>a file that ends in .stl or .obj</source>
        <translation>以 .stl 或 .obj 结尾的文件</translation>
    </message>
    <message>
        <source>the mesh&apos;s file is larger than 512 MB</source>
        <translation>网格文件大于 512 MB</translation>
    </message>
    <message>
        <source>export it coarser</source>
        <translation>以更粗的网格导出</translation>
    </message>
    <message>
        <source>the mesh cannot be read</source>
        <translation>无法读取网格</translation>
    </message>
    <message>
        <source>export it again, e.g. as binary STL</source>
        <translation>重新导出，例如导出为二进制 STL</translation>
    </message>
    <message>
        <source>the mesh has more than {} triangles</source>
        <translation>网格的三角形超过 {} 个</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>网格没有三角形</translation>
    </message>
    <message>
        <source>export it again as STL or OBJ</source>
        <translation>重新导出为 STL 或 OBJ</translation>
    </message>
    <message>
        <source>the mesh has holes: {} edges do not border two triangles</source>
        <translation>网格有孔洞：{} 条边不与两个三角形相邻</translation>
    </message>
    <message>
        <source>close it in the program that made it</source>
        <translation>在生成它的程序中补好孔洞</translation>
    </message>
    <message>
        <source>which untouched picture a frame is compared with: the one of the finger at rest, the nearest recorded one, or one computed from the nearest several</source>
        <translation>与哪张未触碰图片比较：手指静止时的图片、最近的录制图片，或由最近几张算出的图片</translation>
    </message>
    <message>
        <source>The finger&apos;s body gives way to what pushes it</source>
        <translation>手指主体受推时变形</translation>
    </message>
    <message>
        <source>a flat sensor has no body that gives way</source>
        <translation>平面传感器没有会变形的主体</translation>
    </message>
    <message>
        <source>leave body out</source>
        <translation>去掉 body</translation>
    </message>
    <message>
        <source>nothing pushes, so no body gives way</source>
        <translation>没有推力，因此主体不会变形</translation>
    </message>
    <message>
        <source>name push too</source>
        <translation>同时写上 push</translation>
    </message>
    <message>
        <source>A cylinder is pressed in lying</source>
        <translation>一个平放的圆柱压入接触面</translation>
    </message>
    <message>
        <source>sd_px in place of focus_mm and aperture_mm</source>
        <translation>用 sd_px 代替 focus_mm 和 aperture_mm</translation>
    </message>
    <message>
        <source>The lens bends straight lines</source>
        <translation>镜头使直线变弯</translation>
    </message>
    <message>
        <source>an orthographic camera has no lens</source>
        <translation>正交相机没有镜头</translation>
    </message>
    <message>
        <source>leave distortion out</source>
        <translation>去掉 distortion</translation>
    </message>
    <message>
        <source>An edge is pressed into the face</source>
        <translation>一条棱压入接触面</translation>
    </message>
    <message>
        <source>the body would be {:g} mm large</source>
        <translation>物体的大小会是 {:g} mm</translation>
    </message>
    <message>
        <source>&apos;scale&apos; says how many mm a unit of the file is</source>
        <translation>&apos;scale&apos; 表示文件的一个单位是多少 mm</translation>
    </message>
    <message>
        <source>A body is pressed into the face</source>
        <translation>一个物体压入接触面</translation>
    </message>
    <message>
        <source>The camera looks through a flat window into the silicone</source>
        <translation>相机透过平面窗口看入硅胶</translation>
    </message>
    <message>
        <source>parallel rays pass a window unbent</source>
        <translation>平行光线穿过窗口时不偏折</translation>
    </message>
    <message>
        <source>leave port out</source>
        <translation>去掉 port</translation>
    </message>
    <message>
        <source>A flat punch is pressed into the face</source>
        <translation>一个平压头压入接触面</translation>
    </message>
    <message>
        <source>nothing pushes</source>
        <translation>没有推力</translation>
    </message>
    <message>
        <source>a force above 0, or no push</source>
        <translation>大于 0 的力，或去掉 push</translation>
    </message>
    <message>
        <source>A ball pushes against the finger</source>
        <translation>一个球推压手指</translation>
    </message>
    <message>
        <source>a flat sensor has a contact face only</source>
        <translation>平面传感器只有接触面</translation>
    </message>
    <message>
        <source>face: contact</source>
        <translation>face: contact</translation>
    </message>
    <message>
        <source>a body that creeps or is damped remembers a push that is over</source>
        <translation>会蠕变或有阻尼的主体仍受已结束的推力影响</translation>
    </message>
    <message>
        <source>instead of &apos;until&apos;, a force_N that goes to 0</source>
        <translation>不用 &apos;until&apos;，而让 force_N 降到 0</translation>
    </message>
    <message>
        <source>nothing drags</source>
        <translation>没有切向拉力</translation>
    </message>
    <message>
        <source>another force, or leave it out</source>
        <translation>换一个力，或去掉它</translation>
    </message>
    <message>
        <source>without its body the finger gives way on its contact face only</source>
        <translation>没有主体时，手指只在接触面上变形</translation>
    </message>
    <message>
        <source>name the effect body too</source>
        <translation>同时写上效果 body</translation>
    </message>
    <message>
        <source>the push bends the finger further than the model reaches</source>
        <translation>推力使手指的弯曲超出模型范围</translation>
    </message>
    <message>
        <source>up to {:.2g} of these forces, or a stiffer body</source>
        <translation>不超过这些力的 {:.2g} 倍，或使用更硬的主体</translation>
    </message>
    <message>
        <source>the height map is too small</source>
        <translation>高度图太小</translation>
    </message>
    <message>
        <source>2 x 2 pixels or more</source>
        <translation>2 x 2 像素以上</translation>
    </message>
    <message>
        <source>The finger twists about its length</source>
        <translation>手指绕其长轴扭转</translation>
    </message>
    <message>
        <source>a flat sensor does not twist</source>
        <translation>平面传感器不会扭转</translation>
    </message>
    <message>
        <source>leave twist out</source>
        <translation>去掉 twist</translation>
    </message>
    <message>
        <source>marker {} is listed twice</source>
        <translation>标记点 {} 出现两次</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>每个编号一次</translation>
    </message>
    <message>
        <source>a modulus or a length of {:g} is not one of a layer</source>
        <translation>层的弹性模量或长度不可能是 {:g}</translation>
    </message>
    <message>
        <source>numbers above 0</source>
        <translation>大于 0 的数</translation>
    </message>
    <message>
        <source>{:g} N press the ball further into the layer than is known</source>
        <translation>{:g} N 把球压入层的深度超出已知范围</translation>
    </message>
    <message>
        <source>up to {:.3g} N, a larger ball or a harder layer</source>
        <translation>不超过 {:.3g} N，或使用更大的球或更硬的层</translation>
    </message>
    <message>
        <source>a modulus or a length of {:g} is not one of a body</source>
        <translation>主体的弹性模量或长度不可能是 {:g}</translation>
    </message>
    <message>
        <source>two walls of {:g} mm do not fit into a depth of {:g} mm</source>
        <translation>两个 {:g} mm 厚的壁放不进 {:g} mm 的深度</translation>
    </message>
    <message>
        <source>walls of up to {:g} mm</source>
        <translation>壁厚不超过 {:g} mm</translation>
    </message>
    <message>
        <source>a coupling of {:g} is not a share</source>
        <translation>耦合 {:g} 不是一个比例</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 到 1</translation>
    </message>
    <message>
        <source>{:g} is no modulus, radius, force or friction of a contact</source>
        <translation>{:g} 不可能是接触的弹性模量、半径、力或摩擦系数</translation>
    </message>
    <message>
        <source>the tangential force is not a number</source>
        <translation>切向力不是数</translation>
    </message>
    <message>
        <source>newtons</source>
        <translation>以牛顿为单位的数</translation>
    </message>
    <message>
        <source>{:g} N press the ball further into the body than is known</source>
        <translation>{:g} N 把球压入主体的深度超出已知范围</translation>
    </message>
    <message>
        <source>up to {:.3g} N, a larger ball or a harder body</source>
        <translation>不超过 {:.3g} N，或使用更大的球或更硬的主体</translation>
    </message>
    <message>
        <source>a hardness of {:g} Shore A has no known modulus</source>
        <translation>邵氏 A 硬度 {:g} 没有已知的弹性模量</translation>
    </message>
    <message>
        <source>a lens does not change while it looks</source>
        <translation>镜头在拍摄期间不会改变</translation>
    </message>
    <message>
        <source>leave &apos;from&apos; and &apos;until&apos; out</source>
        <translation>去掉 &apos;from&apos; 和 &apos;until&apos;</translation>
    </message>
    <message>
        <source>stopped before the twin was found</source>
        <translation>得出数字孪生之前已停止</translation>
    </message>
    <message>
        <source>there is no pressed picture</source>
        <translation>没有按压图片</translation>
    </message>
    <message>
        <source>pictures of a ball of known radius pressed into the face</source>
        <translation>半径已知的球压入面的图片</translation>
    </message>
    <message>
        <source>noise is told from {} untouched pictures</source>
        <translation>噪声由 {} 张未触碰的图片得出</translation>
    </message>
    <message>
        <source>noise in time is told from one untouched picture and {} beside its contact</source>
        <translation>时间噪声由一张未触碰的图片和 {} 中接触以外的部分得出</translation>
    </message>
    <message>
        <source>{}: too little around the contact can be compared</source>
        <translation>{}：接触周围可比较的部分太少</translation>
    </message>
    <message>
        <source>a press further from the face&apos;s edges</source>
        <translation>离面的边缘更远的按压</translation>
    </message>
    <message>
        <source>fitting the presses</source>
        <translation>正在拟合按压</translation>
    </message>
    <message>
        <source>not observable: at the end of its range, or another number does the same</source>
        <translation>无法确定：处于范围的端点，或另一个数有同样的作用</translation>
    </message>
    <message>
        <source>hardly observable in these pictures</source>
        <translation>由这些图片难以确定</translation>
    </message>
    <message>
        <source>scattering of the layer, per mm</source>
        <translation>层的散射，每 mm</translation>
    </message>
    <message>
        <source>what the coat below the layer reflects</source>
        <translation>层下涂层的反射</translation>
    </message>
    <message>
        <source>the coat below the layer is taken to be black: the presses do not say otherwise</source>
        <translation>层下的涂层视为黑色：按压没有表明不是这样</translation>
    </message>
    <message>
        <source>absorption in the layer is not observable: scattering and coat bend the same curve</source>
        <translation>层内的吸收无法确定：散射和涂层改变的是同一条曲线</translation>
    </message>
    <message>
        <source>roll-off length, mm</source>
        <translation>过渡长度，mm</translation>
    </message>
    <message>
        <source>no swelling around the contacts is to be seen</source>
        <translation>接触周围看不到隆起</translation>
    </message>
    <message>
        <source>height of the swelling, share of the layer</source>
        <translation>隆起的高度，占层厚的比例</translation>
    </message>
    <message>
        <source>its distance from the rim, mm</source>
        <translation>隆起到接触边缘的距离，mm</translation>
    </message>
    <message>
        <source>how steeply it falls off</source>
        <translation>隆起下降的陡度</translation>
    </message>
    <message>
        <source>blur, standard deviation in pixels</source>
        <translation>模糊，标准差，单位像素</translation>
    </message>
    <message>
        <source>no blur is to be seen beside the roll-off</source>
        <translation>除过渡之外看不到模糊</translation>
    </message>
    <message>
        <source>{}: depth, mm</source>
        <translation>{}：深度，mm</translation>
    </message>
    <message>
        <source>{}: place along the face, mm</source>
        <translation>{}：沿面的位置，mm</translation>
    </message>
    <message>
        <source>{}: place across the face, mm</source>
        <translation>{}：面上横向的位置，mm</translation>
    </message>
    <message>
        <source>{}: light, share of that in its untouched picture</source>
        <translation>{}：光照，占其未触碰图片中光照的比例</translation>
    </message>
    <message>
        <source>lamp {}: power</source>
        <translation>灯 {}：功率</translation>
    </message>
    <message>
        <source>lamp {}: distance from the face, mm</source>
        <translation>灯 {}：到面的距离，mm</translation>
    </message>
    <message>
        <source>lamp {}: distance from the camera, mm</source>
        <translation>灯 {}：到相机的距离，mm</translation>
    </message>
    <message>
        <source>the lamps make the light on the face, and need not be where the real ones are: {} of {} places are not observable</source>
        <translation>这些灯给出面上的光照，不一定在真实灯的位置：有 {} 个位置（共 {} 个）无法确定</translation>
    </message>
    <message>
        <source>read noise, grey levels</source>
        <translation>读出噪声，灰度级</translation>
    </message>
    <message>
        <source>shot noise, grey levels</source>
        <translation>散粒噪声，灰度级</translation>
    </message>
    <message>
        <source>shot noise cannot be told from read noise: the face is too evenly lit, or there is none</source>
        <translation>散粒噪声与读出噪声无法区分：面的光照太均匀，或没有散粒噪声</translation>
    </message>
    <message>
        <source>fixed pattern, share</source>
        <translation>固定图案，比例</translation>
    </message>
    <message>
        <source>the scene holds the face alone: no side faces, no dots, no twist</source>
        <translation>场景只含接触面：没有侧面、标记点和扭转</translation>
    </message>
    <message>
        <source>there is no untouched picture of this finger to compare with</source>
        <translation>没有可供比较的此手指未触碰的图片</translation>
    </message>
    <message>
        <source>--reference with a picture in which nothing touches it</source>
        <translation>用 --reference 给出没有东西触碰它的图片</translation>
    </message>
    <message>
        <source>a picture of this finger, at the size of its camera</source>
        <translation>此手指的图片，尺寸与其相机相同</translation>
    </message>
    <message>
        <source>a punch with a step is no ball</source>
        <translation>带台阶的压头不是球</translation>
    </message>
    <message>
        <source>the radius of the ball that was pressed is not known</source>
        <translation>压入的球的半径未知</translation>
    </message>
    <message>
        <source>--ball-radius-mm with the radius of the ball</source>
        <translation>用 --ball-radius-mm 给出球的半径</translation>
    </message>
    <message>
        <source>no press was given, and the finger keeps none</source>
        <translation>没有给出按压，手指中也没有保存</translation>
    </message>
    <message>
        <source>pictures of a ball of known radius pressed into its face</source>
        <translation>半径已知的球压入其面的图片</translation>
    </message>
    <message>
        <source>too little of the untouched face is seen</source>
        <translation>看得见的未触碰面太少</translation>
    </message>
    <message>
        <source>pictures in which the whole face is seen</source>
        <translation>看得见整个面的图片</translation>
    </message>
    <message>
        <source>no lamp would light the face</source>
        <translation>没有灯会照亮面</translation>
    </message>
    <message>
        <source>checking the finger&apos;s face</source>
        <translation>检查手指的面</translation>
    </message>
    <message>
        <source>finding the lamps</source>
        <translation>正在寻找灯</translation>
    </message>
    <message>
        <source>no lamp comes near the untouched picture</source>
        <translation>没有灯能接近未触碰的图片</translation>
    </message>
    <message>
        <source>noise is told from single pictures: a fixed pattern of the camera cannot be told from noise in time</source>
        <translation>噪声由单张图片得出：相机的固定图案与时间噪声无法区分</translation>
    </message>
    <message>
        <source>too little of the finger&apos;s length is seen</source>
        <translation>看得见的手指长度太短</translation>
    </message>
    <message>
        <source>the finger&apos;s base is on the right of the picture, and no scene has it there</source>
        <translation>手指的根部在图片右侧，而场景中根部都不在那里</translation>
    </message>
    <message>
        <source>camera.orientation: flip_u in finger.yaml</source>
        <translation>在 finger.yaml 中写上 camera.orientation: flip_u</translation>
    </message>
    <message>
        <source>no scene was found whose pictures come near these</source>
        <translation>没有找到图片与这些接近的场景</translation>
    </message>
    <message>
        <source>pictures of one ball, pressed in where the whole contact is seen</source>
        <translation>同一个球的图片，压在看得见整个接触的位置</translation>
    </message>
    <message>
        <source>alltact force with a table of this finger&apos;s markers</source>
        <translation>用此手指标记点的表运行 alltact force</translation>
    </message>
    <message>
        <source>the force model was trained with {} markers, the finger has {} others</source>
        <translation>力模型用 {} 个标记点训练，而手指有 {} 个不同的标记点</translation>
    </message>
    <message>
        <source>the force model belongs to another reference: its markers rested up to {:.1f} px from where they rest now</source>
        <translation>力模型属于另一个参考：其标记点的静止位置与现在相差达 {:.1f} px</translation>
    </message>
    <message>
        <source>train the force model again</source>
        <translation>重新训练力模型</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>不是对象</translation>
    </message>
    <message>
        <source>is no number</source>
        <translation>不是数</translation>
    </message>
    <message>
        <source>is no possible number</source>
        <translation>不是可能的数</translation>
    </message>
    <message>
        <source>is no whole number</source>
        <translation>不是整数</translation>
    </message>
    <message>
        <source>is no list</source>
        <translation>不是列表</translation>
    </message>
    <message>
        <source>holds {} numbers, not {} x {}</source>
        <translation>含有 {} 个数，而不是 {} x {} 个</translation>
    </message>
    <message>
        <source>is not true or false</source>
        <translation>不是 true 或 false</translation>
    </message>
    <message>
        <source>must be two places</source>
        <translation>必须是两个位置</translation>
    </message>
    <message>
        <source>must be mean, ridge, quadratic or network</source>
        <translation>必须是 mean、ridge、quadratic 或 network</translation>
    </message>
    <message>
        <source>holds what is no text</source>
        <translation>含有不是文本的内容</translation>
    </message>
    <message>
        <source>has not the shape that the rest of the model needs</source>
        <translation>形状与模型其余部分不符</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>必须大于 0</translation>
    </message>
    <message>
        <source>is no possible range</source>
        <translation>不是可能的范围</translation>
    </message>
    <message>
        <source>holds what is no number</source>
        <translation>含有不是数的内容</translation>
    </message>
    <message>
        <source>must be 2 or 3</source>
        <translation>必须是 2 或 3</translation>
    </message>
    <message>
        <source>must be a whole number from 1 to 1024</source>
        <translation>必须是 1 到 1024 的整数</translation>
    </message>
    <message>
        <source>must be a number from 0 to 1000000</source>
        <translation>必须是 0 到 1000000 的数</translation>
    </message>
    <message>
        <source>must be 1 to {}</source>
        <translation>必须有 1 到 {} 个</translation>
    </message>
    <message>
        <source>are missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>is no force model: it is broken or cut off</source>
        <translation>不是力模型：文件已损坏或不完整</translation>
    </message>
    <message>
        <source>must be two motor positions, the lower one first</source>
        <translation>必须是两个电机位置，较小的在前</translation>
    </message>
    <message>
        <source>for example [0.0, 12.5]</source>
        <translation>例如 [0.0, 12.5]</translation>
    </message>
    <message>
        <source>must be from 0 to 1000</source>
        <translation>必须在 0 到 1000 之间</translation>
    </message>
    <message>
        <source>how far a motor position may be off, with the screw&apos;s play</source>
        <translation>电机位置可能有多大偏差，包括丝杠的间隙</translation>
    </message>
    <message>
        <source>must name the finger&apos;s folder</source>
        <translation>必须给出手指的文件夹</translation>
    </message>
    <message>
        <source>its path from the folder of this file, for example ../left-07</source>
        <translation>从此文件所在的文件夹到它的路径，例如 ../left-07</translation>
    </message>
    <message>
        <source>goes beyond what the finger {} can reach: at {:.6g} turns {}</source>
        <translation>超出手指 {} 能到达的范围：在 {:.6g} 圈处，{}</translation>
    </message>
    <message>
        <source>a range within {:.6g} to {:.6g}</source>
        <translation>{:.6g} 到 {:.6g} 之内的范围</translation>
    </message>
    <message>
        <source>must say where the camera sits in one way</source>
        <translation>必须用且只用一种方式说明相机的安装位置</translation>
    </message>
    <message>
        <source>this, or known_at_turns: the motor position at which gripper_from_camera in the finger&apos;s own file holds</source>
        <translation>写这一项，或写 known_at_turns：手指自己的文件中 gripper_from_camera 成立时的电机位置</translation>
    </message>
    <message>
        <source>must lie in the motor&apos;s range</source>
        <translation>必须在电机的范围内</translation>
    </message>
    <message>
        <source>a motor position from {:g} to {:g}</source>
        <translation>{:g} 到 {:g} 的电机位置</translation>
    </message>
    <message>
        <source>what is written on the gripper</source>
        <translation>写在夹爪上的名字</translation>
    </message>
    <message>
        <source>is the name of the other finger too</source>
        <translation>与另一个手指的名字相同</translation>
    </message>
    <message>
        <source>two names, for example left and right</source>
        <translation>两个不同的名字，例如 left 和 right</translation>
    </message>
    <message>
        <source>does not say where the camera sits in the gripper</source>
        <translation>没有说明相机在夹爪中的位置</translation>
    </message>
    <message>
        <source>add gripper_from_camera there, as it is at {:g} turns of the motor</source>
        <translation>在其中加上 gripper_from_camera，取电机在 {:g} 圈时的值</translation>
    </message>
    <message>
        <source>the motor cannot stand at {:.6g} turns: its range is from {:.6g} to {:.6g}</source>
        <translation>电机不能停在 {:.6g} 圈：其范围是 {:.6g} 到 {:.6g}</translation>
    </message>
    <message>
        <source>a motor position in that range, or correct range_turns</source>
        <translation>使用该范围内的电机位置，或更正 range_turns</translation>
    </message>
    <message>
        <source>the standard deviation of a motor position must be 0 or above</source>
        <translation>电机位置的标准差必须大于或等于 0</translation>
    </message>
    <message>
        <source>a number of turns</source>
        <translation>以圈为单位的数</translation>
    </message>
    <message>
        <source>it is not known where the camera of finger {} sits</source>
        <translation>不知道手指 {} 的相机的安装位置</translation>
    </message>
    <message>
        <source>must be two numbers: x and z in mm</source>
        <translation>必须是两个数：x 和 z，单位 mm</translation>
    </message>
    <message>
        <source>a travel in mm for each turn</source>
        <translation>每圈的行程，单位 mm</translation>
    </message>
    <message>
        <source>a motor position</source>
        <translation>电机位置</translation>
    </message>
    <message>
        <source>must be two fingers, not {}</source>
        <translation>必须是两个手指，而不是 {} 个</translation>
    </message>
    <message>
        <source>one block &apos;- name: ...&apos; for each</source>
        <translation>每个手指写一段 &apos;- name: ...&apos;</translation>
    </message>
    <message>
        <source>must be above 0 and at most {:g}</source>
        <translation>必须大于 0 且不超过 {:g}</translation>
    </message>
    <message>
        <source>rod and crank are stretched into one line</source>
        <translation>连杆与曲柄伸直成一条线</translation>
    </message>
    <message>
        <source>rod and crank are folded into one line</source>
        <translation>连杆与曲柄重叠成一条线</translation>
    </message>
    <message>
        <source>the rod lies across the screw</source>
        <translation>连杆与丝杠垂直</translation>
    </message>
    <message>
        <source>must be a travel in mm, above or below 0</source>
        <translation>必须是以 mm 为单位的行程，大于或小于 0</translation>
    </message>
    <message>
        <source>how far the nut goes away from the palm in one turn, for example 2.0</source>
        <translation>电机转一圈时螺母远离手掌的距离，例如 2.0</translation>
    </message>
    <message>
        <source>must be numbers from -{0:g} to {0:g}</source>
        <translation>必须是 -{0:g} 到 {0:g} 的数</translation>
    </message>
    <message>
        <source>x and z of the axis that the finger turns about, in mm</source>
        <translation>手指转轴的 x 和 z，单位 mm</translation>
    </message>
    <message>
        <source>x and z of the rod&apos;s joint on the nut at motor position 0, in mm</source>
        <translation>电机位置为 0 时连杆在螺母上的铰接点的 x 和 z，单位 mm</translation>
    </message>
    <message>
        <source>the distance from the finger&apos;s axis to the rod, in mm</source>
        <translation>手指转轴到连杆的距离，单位 mm</translation>
    </message>
    <message>
        <source>the distance between the rod&apos;s joints, in mm</source>
        <translation>连杆两个铰接点之间的距离，单位 mm</translation>
    </message>
    <message>
        <source>rod and crank never meet: together they reach {:g} mm, and the nut passes the finger&apos;s axis at {:g} mm</source>
        <translation>连杆与曲柄永远不能相接：两者合起来可达 {:g} mm，而螺母在距手指转轴 {:g} mm 处经过</translation>
    </message>
    <message>
        <source>measure pivot_mm, nut_mm, crank_mm and rod_mm again</source>
        <translation>重新测量 pivot_mm、nut_mm、crank_mm 和 rod_mm</translation>
    </message>
    <message>
        <source>the motor&apos;s position is no number</source>
        <translation>电机位置不是数</translation>
    </message>
    <message>
        <source>at {:.6g} turns the rod&apos;s joint lies on the finger&apos;s axis, so that the finger may stand anywhere</source>
        <translation>在 {:.6g} 圈处，连杆的铰接点落在手指转轴上，因此手指可处于任意角度</translation>
    </message>
    <message>
        <source>another motor position</source>
        <translation>换一个电机位置</translation>
    </message>
    <message>
        <source>rod and crank do not meet at {:.6g} turns: they do from {:.6g} ({}) to {:.6g} ({})</source>
        <translation>连杆与曲柄在 {:.6g} 圈处不能相接：可相接的范围是 {:.6g}（{}）到 {:.6g}（{}）</translation>
    </message>
    <message>
        <source>a motor position between these</source>
        <translation>这两者之间的电机位置</translation>
    </message>
    <message>
        <source>must be &apos;{}&apos;, not &apos;{}&apos;</source>
        <translation>必须是 &apos;{}&apos;，而不是 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>a table of motor positions by time</source>
        <translation>按时间排列的电机位置表</translation>
    </message>
    <message>
        <source>must be a time in ns and a number of turns, not &apos;{}&apos;</source>
        <translation>必须是以 ns 为单位的时间和圈数，而不是 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>for example 123456789,4.25</source>
        <translation>例如 123456789,4.25</translation>
    </message>
    <message>
        <source>the time is not after that of the line before</source>
        <translation>时间不晚于上一行的时间</translation>
    </message>
    <message>
        <source>lines in the order of time</source>
        <translation>按时间顺序排列各行</translation>
    </message>
    <message>
        <source>holds fewer than two motor positions</source>
        <translation>含有的电机位置少于两个</translation>
    </message>
    <message>
        <source>a line for each time at which the motor was read</source>
        <translation>每次读取电机的时刻写一行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a number</source>
        <translation>&apos;{}&apos; 必须是数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be {} numbers</source>
        <translation>&apos;{}&apos; 必须是 {} 个数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be numbers</source>
        <translation>&apos;{}&apos; 必须由数组成</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be of length 1</source>
        <translation>&apos;{}&apos; 的长度必须是 1</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no covariance</source>
        <translation>&apos;{}&apos; 不是协方差</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be 0 or above</source>
        <translation>&apos;{}&apos; 必须大于或等于 0</translation>
    </message>
    <message>
        <source>is no JSON object</source>
        <translation>不是 JSON 对象</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a text</source>
        <translation>&apos;{}&apos; 必须是文本</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a whole number</source>
        <translation>&apos;{}&apos; 必须是整数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list</source>
        <translation>&apos;{}&apos; 必须是列表</translation>
    </message>
    <message>
        <source>a region is no JSON object</source>
        <translation>有一个区域不是 JSON 对象</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must ascend</source>
        <translation>&apos;{}&apos; 必须按升序排列</translation>
    </message>
    <message>
        <source>is no JSON: {}</source>
        <translation>不是 JSON：{}</translation>
    </message>
    <message>
        <source>results.jsonl as alltact reconstruct wrote it</source>
        <translation>使用 alltact reconstruct 写出的 results.jsonl</translation>
    </message>
    <message>
        <source>no marker is seen that could tell the force</source>
        <translation>看不到可用来得出力的标记点</translation>
    </message>
    <message>
        <source>the force model was trained with nothing like this frame: its force cannot be relied on; add rows with such forces to the table and train it again</source>
        <translation>力模型的训练数据中没有与此帧相似的情况：这一帧的力不可靠；请在表中加入含这类力的行并重新训练</translation>
    </message>
    <message>
        <source>{}, trained at an unknown date</source>
        <translation>{}，训练日期不明</translation>
    </message>
    <message>
        <source>{}, trained {}</source>
        <translation>{}，训练于 {}</translation>
    </message>
    <message>
        <source>holds no frame with markers</source>
        <translation>没有含标记点的帧</translation>
    </message>
    <message>
        <source>results.jsonl of alltact reconstruct, or the recording itself</source>
        <translation>使用 alltact reconstruct 的 results.jsonl，或录像本身</translation>
    </message>
    <message>
        <source>stopped before all frames were measured</source>
        <translation>测量完所有帧之前已停止</translation>
    </message>
    <message>
        <source>measuring frame {}</source>
        <translation>正在测量第 {} 帧</translation>
    </message>
    <message>
        <source>the markers were found in no frame</source>
        <translation>在任何一帧中都没有找到标记点</translation>
    </message>
    <message>
        <source>alltact reconstruct, which says why</source>
        <translation>运行 alltact reconstruct，它会说明原因</translation>
    </message>
    <message>
        <source>The gauge and the camera were on different clocks: their beginnings are taken for one moment.</source>
        <translation>测力计和相机使用不同的时钟：以各自的开头为同一时刻。</translation>
    </message>
    <message>
        <source>the recording&apos;s frames have no times, the gauge has nothing but times</source>
        <translation>录像的帧没有时间，而测力计只有时间</translation>
    </message>
    <message>
        <source>a recording of alltact record, or a gauge file with a column &apos;frame&apos;</source>
        <translation>使用 alltact record 的录像，或带有列 &apos;frame&apos; 的测力计文件</translation>
    </message>
    <message>
        <source>{} of {} frames have a reading</source>
        <translation>有读数的帧：{} / {}</translation>
    </message>
    <message>
        <source>a CSV whose first line names t_s (or frame), fx_n and fy_n</source>
        <translation>第一行含有 t_s（或 frame）、fx_n 和 fy_n 的 CSV 文件</translation>
    </message>
    <message>
        <source>the gauge&apos;s file holds no reading</source>
        <translation>测力计文件中没有读数</translation>
    </message>
    <message>
        <source>the gauge&apos;s file is empty</source>
        <translation>测力计文件是空的</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is given twice</source>
        <translation>列 &apos;{}&apos; 出现两次</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is missing</source>
        <translation>缺少列 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>there is neither a column &apos;t_s&apos; nor a column &apos;frame&apos;</source>
        <translation>既没有列 &apos;t_s&apos;，也没有列 &apos;frame&apos;</translation>
    </message>
    <message>
        <source>of the place of contact there is only one of along_mm and across_mm</source>
        <translation>接触位置只给出了 along_mm 和 across_mm 中的一个</translation>
    </message>
    <message>
        <source>has {} cells, not {}</source>
        <translation>有 {} 个单元格，而不是 {} 个</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no force</source>
        <translation>&apos;{}&apos; 不是力</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no time</source>
        <translation>&apos;{}&apos; 不是时间</translation>
    </message>
    <message>
        <source>{} s comes after {} s</source>
        <translation>{} s 排在 {} s 之后</translation>
    </message>
    <message>
        <source>the place of contact is no pair of numbers</source>
        <translation>接触位置不是一对数</translation>
    </message>
    <message>
        <source>truth.json of a scene whose pushes have forces</source>
        <translation>推压带有力的场景的 truth.json</translation>
    </message>
    <message>
        <source>holds no frames of a simulation</source>
        <translation>不含仿真的帧</translation>
    </message>
    <message>
        <source>holds a frame without a name</source>
        <translation>含有没有名字的帧</translation>
    </message>
    <message>
        <source>tells no force of any contact</source>
        <translation>没有给出任何接触的力</translation>
    </message>
    <message>
        <source>the table has no column &apos;{}&apos;</source>
        <translation>表中没有列 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is the same in all rows</source>
        <translation>列 &apos;{}&apos; 在所有行中都相同</translation>
    </message>
    <message>
        <source>--split block, or a table of several</source>
        <translation>使用 --split block，或使用该列有多个不同值的表</translation>
    </message>
    <message>
        <source>a CSV whose first line names u0, v0, ..., fx_n, fy_n; alltact force --collect makes one</source>
        <translation>第一行含有 u0, v0, ..., fx_n, fy_n 的 CSV 文件；alltact force --collect 可生成</translation>
    </message>
    <message>
        <source>{}, line 1</source>
        <translation>{}，第 1 行</translation>
    </message>
    <message>
        <source>there are no columns u0, v0, ... of markers</source>
        <translation>没有标记点的列 u0, v0, ...</translation>
    </message>
    <message>
        <source>there are markers up to number {}; the highest may be {}</source>
        <translation>标记点的编号到了 {}；最大只能是 {}</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is missing, though there is a marker {}</source>
        <translation>缺少列 &apos;{}&apos;，但有标记点 {}</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is missing, though other markers have one</source>
        <translation>缺少列 &apos;{}&apos;，但其他标记点有这样的列</translation>
    </message>
    <message>
        <source>the table is empty</source>
        <translation>表是空的</translation>
    </message>
    <message>
        <source>{}, column {}</source>
        <translation>{}，列 {}</translation>
    </message>
    <message>
        <source>removing the line, or writing what was measured</source>
        <translation>删除此行，或写上测得的值</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no number</source>
        <translation>&apos;{}&apos; 不是数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is beyond all that can be measured</source>
        <translation>&apos;{}&apos; 超出一切可测的范围</translation>
    </message>
    <message>
        <source>seen is 1 or 0</source>
        <translation>seen 只能是 1 或 0</translation>
    </message>
    <message>
        <source>no marker was seen</source>
        <translation>没有看到标记点</translation>
    </message>
    <message>
        <source>{} rows are too few to learn from</source>
        <translation>{} 行太少，无法学习</translation>
    </message>
    <message>
        <source>at least {}, better several hundred</source>
        <translation>至少 {} 行，最好有几百行</translation>
    </message>
    <message>
        <source>the force &apos;{}&apos; is the same in all rows</source>
        <translation>力 &apos;{}&apos; 在所有行中都相同</translation>
    </message>
    <message>
        <source>pressing with different forces, or leaving the column fz_n out</source>
        <translation>用不同的力按压，或去掉列 fz_n</translation>
    </message>
    <message>
        <source>no marker ever moves</source>
        <translation>没有任何标记点移动过</translation>
    </message>
    <message>
        <source>a table of this recording&apos;s markers</source>
        <translation>此录像的标记点的表</translation>
    </message>
    <message>
        <source>a table of this finger&apos;s markers</source>
        <translation>此手指的标记点的表</translation>
    </message>
    <message>
        <source>the finger has no markers, so they cannot tell a force</source>
        <translation>手指没有标记点，因此无法由标记点得出力</translation>
    </message>
    <message>
        <source>a finger with markers</source>
        <translation>有标记点的手指</translation>
    </message>
    <message>
        <source>the finger has no reference, so it is not known where its markers rest</source>
        <translation>手指没有参考，因此不知道其标记点的静止位置</translation>
    </message>
    <message>
        <source>alltact reference</source>
        <translation>运行 alltact reference</translation>
    </message>
    <message>
        <source>the table has {} markers, the finger has {}</source>
        <translation>表中有 {} 个标记点，手指有 {} 个</translation>
    </message>
    <message>
        <source>the table&apos;s markers are another finger&apos;s: in every row they lie {:.0f} px or more from where this finger&apos;s rest</source>
        <translation>表中的标记点属于另一个手指：在每一行中，它们与此手指标记点静止位置的距离都不小于 {:.0f} px</translation>
    </message>
    <message>
        <source>there is no force model to take back</source>
        <translation>没有可撤回的力模型</translation>
    </message>
    <message>
        <source>the finger has no force model yet</source>
        <translation>手指还没有力模型</translation>
    </message>
    <message>
        <source>giving the table to train with</source>
        <translation>给出训练用的表</translation>
    </message>
    <message>
        <source>the force model does not say which table it is of</source>
        <translation>力模型没有说明它来自哪个表</translation>
    </message>
    <message>
        <source>stopped before there was a force model</source>
        <translation>得出力模型之前已停止</translation>
    </message>
    <message>
        <source>the mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>岭回归</translation>
    </message>
    <message>
        <source>the quadratic one</source>
        <translation>二次模型</translation>
    </message>
    <message>
        <source>the network</source>
        <translation>神经网络</translation>
    </message>
    <message>
        <source>creep is an input only where the table has times</source>
        <translation>只有表中有时间时，蠕变才能作为输入</translation>
    </message>
    <message>
        <source>a table with a column t_s, or leaving creep out</source>
        <translation>使用带有列 t_s 的表，或去掉蠕变</translation>
    </message>
    <message>
        <source>training {} without one block after the other</source>
        <translation>正在训练{}，依次留出每个数据块</translation>
    </message>
    <message>
        <source>testing {} by frames and with shuffled forces</source>
        <translation>正在检验{}，按帧并使用打乱的力</translation>
    </message>
    <message>
        <source>The network does not beat ridge: their errors are {:.1f} % and {:.1f} % of the forces&apos; standard deviation.</source>
        <translation>神经网络不优于岭回归：两者的误差分别为力的标准差的 {:.1f} % 和 {:.1f} %。</translation>
    </message>
    <message>
        <source>What is kept does not beat the mean of the table: these markers do not tell the force.</source>
        <translation>保留的模型不优于表的平均值：由这些标记点无法得出力。</translation>
    </message>
    <message>
        <source>Nothing beats the mean of the table: these markers do not tell the force.</source>
        <translation>没有比表的平均值更好的模型：由这些标记点无法得出力。</translation>
    </message>
    <message>
        <source>The table has no column &apos;block&apos;: {} stretches of rows that follow each other were held out.</source>
        <translation>表中没有列 &apos;block&apos;：留出了 {} 段连续的行。</translation>
    </message>
    <message>
        <source>Only {} groups could be held out: errors and intervals are rough.</source>
        <translation>只能留出 {} 组：误差和区间较粗略。</translation>
    </message>
    <message>
        <source>without a depth there is no place on the contact face</source>
        <translation>没有深度就没有接触面上的位置</translation>
    </message>
    <message>
        <source>nothing is seen to be pressed into the part of the contact face in view</source>
        <translation>在可见的接触面部分没有看到任何压入</translation>
    </message>
    <message>
        <source>stopped before the experiments were over</source>
        <translation>在实验结束之前被停止</translation>
    </message>
    <message>
        <source>{}: frame {} of {}</source>
        <translation>{}：第 {} 帧，共 {} 帧</translation>
    </message>
    <message>
        <source>no frame tells what the experiment asks for</source>
        <translation>没有任何一帧能回答该实验的问题</translation>
    </message>
    <message>
        <source>where a touch is, at 9 x 3 places of the face</source>
        <translation>在接触面的 9 x 3 个位置上，接触在哪里</translation>
    </message>
    <message>
        <source>how a held bar is turned</source>
        <translation>被夹持的杆转了多少</translation>
    </message>
    <message>
        <source>the least depth of a ball that is felt</source>
        <translation>能感觉到的最小压球深度</translation>
    </message>
    <message>
        <source>the least force that is felt, on every face</source>
        <translation>每个面上能感觉到的最小力</translation>
    </message>
    <message>
        <source>from which of 8 sides the finger is pushed</source>
        <translation>手指从 8 个方向中的哪一个被推</translation>
    </message>
    <message>
        <source>one untouched picture against a recording of all poses</source>
        <translation>一张未接触图像与全部姿态录像的比较</translation>
    </message>
    <message>
        <source>relief of an M8 thread, against a single reference</source>
        <translation>M8 螺纹的浮雕，与单一参考比较</translation>
    </message>
    <message>
        <source>relief of a USB plug, against a single reference</source>
        <translation>USB 插头的浮雕，与单一参考比较</translation>
    </message>
    <message>
        <source>time of a frame&apos;s steps, in full HD with 24 dots</source>
        <translation>全高清、24 个点时每帧各步骤的时间</translation>
    </message>
    <message>
        <source>there is no experiment &apos;{}&apos;</source>
        <translation>没有实验 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>least force felt on the contact face, over all heights</source>
        <translation>接触面上能感觉到的最小力，全部高度</translation>
    </message>
    <message>
        <source>least force felt on the back, over all heights</source>
        <translation>背面能感觉到的最小力，全部高度</translation>
    </message>
    <message>
        <source>least force felt on the upper side, over all heights</source>
        <translation>上侧面能感觉到的最小力，全部高度</translation>
    </message>
    <message>
        <source>least force felt on the lower side, over all heights</source>
        <translation>下侧面能感觉到的最小力，全部高度</translation>
    </message>
    <message>
        <source>least depth felt, {:.0f} mm from the base</source>
        <translation>距根部 {:.0f} mm 处能感觉到的最小深度</translation>
    </message>
    <message>
        <source>Depths are doubled from 0.01 mm on, so that the least lies between a figure and its half</source>
        <translation>深度从 0.01 mm 起逐次加倍，因此最小值在所给数字与其一半之间</translation>
    </message>
    <message>
        <source>All heights lie beyond {:.0f} mm, where the paper has less than 2 N; the body is rubber of Shore 40 A as the scene has it, and the paper&apos;s silicone is another</source>
        <translation>所有高度都超过 {:.0f} mm，论文在那里不到 2 N；手指主体是场景中的 Shore 40 A 橡胶，论文的硅胶不同</translation>
    </message>
    <message>
        <source>pushes whose side of 8 is told right</source>
        <translation>在 8 个方向中判断正确的推压</translation>
    </message>
    <message>
        <source>direction of a push in the picture, mean error</source>
        <translation>图像中推压方向的平均误差</translation>
    </message>
    <message>
        <source>direction of a push in the picture, greatest error</source>
        <translation>图像中推压方向的最大误差</translation>
    </message>
    <message>
        <source>{} pushes, by how the dots truly moved in the picture; those near a border of two sides are counted as all others</source>
        <translation>{} 次推压，以点在图像中的真实运动为准；靠近两个方向边界的与其他的一样计入</translation>
    </message>
    <message>
        <source>frames under 40 px, nearest of a recording</source>
        <translation>低于 40 px 的帧，录像中最近的一帧</translation>
    </message>
    <message>
        <source>frames under 40 px, one reference</source>
        <translation>低于 40 px 的帧，单一参考</translation>
    </message>
    <message>
        <source>depth where nothing touches, one reference</source>
        <translation>无接触处的深度，单一参考</translation>
    </message>
    <message>
        <source>depth where nothing touches, nearest of a recording</source>
        <translation>无接触处的深度，录像中最近的一帧</translation>
    </message>
    <message>
        <source>depth where nothing touches, local regression</source>
        <translation>无接触处的深度，局部回归</translation>
    </message>
    <message>
        <source>How many frames a single reference is near to depends on how far the finger moves, which is the scene&apos;s choice here and was the paper&apos;s there</source>
        <translation>单一参考接近多少帧取决于手指移动的幅度，这里由场景决定，那里由论文决定</translation>
    </message>
    <message>
        <source>relief, mean depth error, straight</source>
        <translation>浮雕，平均深度误差，伸直</translation>
    </message>
    <message>
        <source>relief, mean depth error, bent</source>
        <translation>浮雕，平均深度误差，弯曲</translation>
    </message>
    <message>
        <source>the same straight, single reference</source>
        <translation>同上，伸直，单一参考</translation>
    </message>
    <message>
        <source>the same bent, single reference</source>
        <translation>同上，弯曲，单一参考</translation>
    </message>
    <message>
        <source>edges and global shape, median</source>
        <translation>边缘和整体形状，中位数</translation>
    </message>
    <message>
        <source>markers and reference, median</source>
        <translation>标记和参考，中位数</translation>
    </message>
    <message>
        <source>local depth and contacts, median</source>
        <translation>局部深度和接触，中位数</translation>
    </message>
    <message>
        <source>whole frame, median</source>
        <translation>整帧，中位数</translation>
    </message>
    <message>
        <source>Times are of this computer, those of the paper of its own; the finger measures with the demonstration&apos;s mapping and 24 recorded poses</source>
        <translation>时间是本计算机的，论文的是其自己的；手指使用演示的映射和 24 个录制姿态测量</translation>
    </message>
    <message>
        <source>place, mean error within +-20 mm of the middle</source>
        <translation>位置，中部 +-20 mm 内的平均误差</translation>
    </message>
    <message>
        <source>place, mean error at the tip</source>
        <translation>位置，指尖处的平均误差</translation>
    </message>
    <message>
        <source>place, greatest error</source>
        <translation>位置，最大误差</translation>
    </message>
    <message>
        <source>touches that are found</source>
        <translation>找到的接触</translation>
    </message>
    <message>
        <source>angle, mean error</source>
        <translation>角度，平均误差</translation>
    </message>
    <message>
        <source>angle, greatest error</source>
        <translation>角度，最大误差</translation>
    </message>
    <message>
        <source>bars whose angle is told</source>
        <translation>给出角度的杆</translation>
    </message>
    <message>
        <source>The lesser of the paper&apos;s two figures stands beside the mean error, the greater one beside the greatest error</source>
        <translation>论文两个数字中较小的与平均误差并列，较大的与最大误差并列</translation>
    </message>
    <message>
        <source>depth inside contacts, mean error at {} lux</source>
        <translation>接触内的深度，{} 勒克斯时的平均误差</translation>
    </message>
    <message>
        <source>the source paper&apos;s method</source>
        <translation>原论文的方法</translation>
    </message>
    <message>
        <source>a picture in which the whole face is bright against its side faces, or our own method</source>
        <translation>整个面明显亮于其侧面的图片，或使用本程序的方法</translation>
    </message>
    <message>
        <source>the binarised picture shows both edges of the face in {} of {} columns, and a fifth of them is needed</source>
        <translation>二值化图像在 {} 列中显示出面的两条边缘（共 {} 列），而至少需要五分之一</translation>
    </message>
    <message>
        <source>no distance of the face follows from its edges</source>
        <translation>由面的边缘得不出面的距离</translation>
    </message>
    <message>
        <source>our own method, which needs no dots, or a recording of a finger that has them</source>
        <translation>使用本程序的方法，它不需要标记点，或使用带标记点的手指的录像</translation>
    </message>
    <message>
        <source>alltact reference with a video of the untouched finger bending</source>
        <translation>用未触碰手指弯曲过程的视频运行 alltact reference</translation>
    </message>
    <message>
        <source>the source paper&apos;s method chooses its reference by the markers, and this finger has none</source>
        <translation>原论文的方法按标记点选择参考，而此手指没有标记点</translation>
    </message>
    <message>
        <source>the source paper&apos;s method sorts two whole rows, and {} of this finger&apos;s dots are missing</source>
        <translation>原论文的方法对两整排标记点排序，而此手指缺少 {} 个标记点</translation>
    </message>
    <message>
        <source>fewer than two dots of a row are seen, from which the source paper&apos;s method could tell the others: uncover and light the dots on the side faces</source>
        <translation>一排中看得见的标记点不足两个，原论文的方法无法由此推断其余的点：请露出并照亮侧面上的标记点</translation>
    </message>
    <message>
        <source>stopped while the recording was read</source>
        <translation>读取录像时已停止</translation>
    </message>
    <message>
        <source>reading the recording as the source paper does</source>
        <translation>正在按原论文的方式读取录像</translation>
    </message>
    <message>
        <source>the reference recording</source>
        <translation>参考录像</translation>
    </message>
    <message>
        <source>recording it anew with this camera</source>
        <translation>用此相机重新录制</translation>
    </message>
    <message>
        <source>the source paper&apos;s method finds face and markers in none of {} frames</source>
        <translation>原论文的方法在 {} 帧中都没有找到面和标记点</translation>
    </message>
    <message>
        <source>our own method, or a recording with brighter dots</source>
        <translation>使用本程序的方法，或标记点更亮的录像</translation>
    </message>
    <message>
        <source>{} dots were found beside the face: too few to sort into two rows</source>
        <translation>在面旁找到 {} 个点：太少，无法排成两排</translation>
    </message>
    <message>
        <source>a network exported with fixed sizes, one picture at a time and opset 11 or 12, or --marker-network own</source>
        <translation>使用以固定尺寸、每次一张图片和 opset 11 或 12 导出的神经网络，或使用 --marker-network own</translation>
    </message>
    <message>
        <source>OpenCV cannot run this network</source>
        <translation>OpenCV 无法运行此神经网络</translation>
    </message>
    <message>
        <source>this network makes {} of {}, which are neither dots nor boxes</source>
        <translation>此神经网络的输出为 {}，输入为 {}，输出既不是点也不是框</translation>
    </message>
    <message>
        <source>this network gives numbers that are not finite</source>
        <translation>此神经网络给出的数不是有限数</translation>
    </message>
    <message>
        <source>the file that says what this network must give is not there</source>
        <translation>缺少说明此神经网络应给出什么结果的文件</translation>
    </message>
    <message>
        <source>training it again, which writes both</source>
        <translation>重新训练，这会写出两个文件</translation>
    </message>
    <message>
        <source>the picture must be as large as what the network takes, {} x {}</source>
        <translation>图片必须与神经网络接受的尺寸相同，即 {} x {}</translation>
    </message>
    <message>
        <source>this network takes {}, not one picture of 1 or 3 channels and a fixed size of {} to {} px a side</source>
        <translation>此神经网络接受 {}，而不是一张 1 或 3 通道、边长固定在 {} 到 {} px 之间的图片</translation>
    </message>
    <message>
        <source>OpenCV cannot read this network (opset {}; it knows those up to 12 well)</source>
        <translation>OpenCV 无法读取此神经网络（opset {}；它能很好地支持 12 及以下）</translation>
    </message>
    <message>
        <source>the network and its .yaml of the same training, or exporting it with opset 11 or 12</source>
        <translation>使用同一次训练得到的神经网络及其 .yaml，或以 opset 11 或 12 导出</translation>
    </message>
    <message>
        <source>the network gives {} numbers where its .yaml has {}</source>
        <translation>神经网络给出 {} 个数，而其 .yaml 中有 {} 个</translation>
    </message>
    <message>
        <source>on a known picture the network gives numbers that are up to {:.3g} off what its .yaml says, and {:.3g} is allowed</source>
        <translation>对一张已知图片，神经网络给出的数与其 .yaml 所述最多相差 {:.3g}，而允许的是 {:.3g}</translation>
    </message>
    <message>
        <source>this is no network in the ONNX format, or only part of one, or damaged</source>
        <translation>这不是 ONNX 格式的神经网络，或者不完整，或者已损坏</translation>
    </message>
    <message>
        <source>copying or exporting the file again</source>
        <translation>重新复制或导出该文件</translation>
    </message>
    <message>
        <source>&apos;crossing&apos; tells the finger&apos;s bend, and with it where a press lies, several times closer</source>
        <translation>&apos;crossing&apos; 得出的手指弯曲以及由此得出的按压位置要精确数倍</translation>
    </message>
    <message>
        <source>&apos;crossing&apos; takes a little longer</source>
        <translation>&apos;crossing&apos; 用时稍长</translation>
    </message>
    <message>
        <source>more hide the noise of dark pictures; beyond 16 a bent finger&apos;s edge is no longer straight within them</source>
        <translation>越多越能抑制暗图像的噪声；超过 16 时，弯曲手指的边缘在其中不再是直的</translation>
    </message>
    <message>
        <source>fewer make more places, each of which the curve has to be fitted to</source>
        <translation>越少则位置越多，曲线须对每个位置进行拟合</translation>
    </message>
    <message>
        <source>higher follows sharper bends; too high follows noise where the edge is hidden</source>
        <translation>越高越能跟随急剧的弯曲；过高则会在边缘被遮住处跟随噪声</translation>
    </message>
    <message>
        <source>higher makes the fit longer</source>
        <translation>越高则拟合用时越长</translation>
    </message>
    <message>
        <source>how the engraved dots are found and numbered: spots followed by how the finger moves, the source paper&apos;s two sorted rows, or a convolutional network in every frame</source>
        <translation>如何找到刻出的标记点并编号：按手指的运动跟踪斑点、原论文的两排排序，或在每一帧中使用卷积神经网络</translation>
    </message>
    <message>
        <source>&apos;network&apos; finds more dots that are worn, dark or badly lit; &apos;paper&apos; loses its numbers where dots are hidden</source>
        <translation>&apos;network&apos; 能找到更多磨损、暗淡或光照不良的标记点；&apos;paper&apos; 在标记点被遮住处会丢失编号</translation>
    </message>
    <message>
        <source>&apos;network&apos; takes many times as long</source>
        <translation>&apos;network&apos; 用时是其他方法的许多倍</translation>
    </message>
    <message>
        <source>the network that marker-method network uses, and paper too where one is named: an ONNX file, a detector such as YOLO11 among them</source>
        <translation>marker-method network 使用的神经网络，指定时 paper 也使用：一个 ONNX 文件，也可以是 YOLO11 之类的检测器</translation>
    </message>
    <message>
        <source>&apos;local&apos; keeps depth of a bent finger right between the recorded poses; &apos;single&apos; is right at rest alone</source>
        <translation>&apos;local&apos; 使弯曲手指在已录制姿态之间的深度保持正确；&apos;single&apos; 只在静止时正确</translation>
    </message>
    <message>
        <source>&apos;local&apos; adds up several pictures instead of one</source>
        <translation>&apos;local&apos; 要累加多张图片，而不是一张</translation>
    </message>
    <message>
        <source>&apos;corrected&apos; keeps depth right when the room or the lamp changes</source>
        <translation>&apos;corrected&apos; 在房间或灯光变化时使深度保持正确</translation>
    </message>
    <message>
        <source>&apos;corrected&apos; looks once over the untouched skin</source>
        <translation>&apos;corrected&apos; 要查看一遍未触碰的表皮</translation>
    </message>
    <message>
        <source>more quiets the depth of a smooth contact and rounds off edges and threads</source>
        <translation>越多则平滑接触的深度噪声越小，但边缘和螺纹会变圆</translation>
    </message>
    <message>
        <source>more takes longer, none the least</source>
        <translation>越多用时越长，不平滑用时最短</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>值为空</translation>
    </message>
    <message>
        <source>could not write the gauge&apos;s readings</source>
        <translation>无法写入测力计的读数</translation>
    </message>
    <message>
        <source>The gauge is back.</source>
        <translation>测力计已恢复。</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no direction</source>
        <translation>“{}”不是方向</translation>
    </message>
    <message>
        <source>x, -y, 0.6,0.8,0 or, for several values, x/y/z</source>
        <translation>x、-y、0.6,0.8,0，有多个值时用 x/y/z</translation>
    </message>
    <message>
        <source>such as &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;, or a table with at, type, scale, zero, unit</source>
        <translation>如 &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;，或带有 at、type、scale、zero、unit 的表格</translation>
    </message>
    <message>
        <source>&apos;{}&apos; describes no report of a gauge</source>
        <translation>“{}”没有描述测力计的报告</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no {}</source>
        <translation>“{}”不能用作 {}</translation>
    </message>
    <message>
        <source>the table describes no report of a gauge</source>
        <translation>表格没有描述测力计的报告</translation>
    </message>
    <message>
        <source>The device tells other reports than the one described. Try: its id and length.</source>
        <translation>设备发送的报告与所描述的不同。建议：检查其 id 和长度。</translation>
    </message>
    <message>
        <source>there is no gauge &apos;{}&apos;</source>
        <translation>没有测力计“{}”</translation>
    </message>
    <message>
        <source>mark10, imada or sauter, or the question and the speed</source>
        <translation>使用 mark10、imada 或 sauter，或给出查询命令和速率</translation>
    </message>
    <message>
        <source>there are {} directions for {} values</source>
        <translation>有 {} 个方向，却有 {} 个值</translation>
    </message>
    <message>
        <source>one for each, as x/y/z</source>
        <translation>每个值一个方向，如 x/y/z</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no text with \r, \n, \xHH</source>
        <translation>“{}”不是带有 \r、\n、\xHH 的文本</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no unit of force</source>
        <translation>“{}”不是力的单位</translation>
    </message>
    <message>
        <source>N, mN, kN, g, kgf, lbf or ozf</source>
        <translation>N、mN、kN、g、kgf、lbf 或 ozf</translation>
    </message>
    <message>
        <source>of a HID gauge the unit is told with its report</source>
        <translation>HID 测力计的单位在其报告描述中给出</translation>
    </message>
    <message>
        <source>unit= in the report&apos;s description</source>
        <translation>在报告描述中使用 unit=</translation>
    </message>
    <message>
        <source>model, speed and question are of a serial gauge</source>
        <translation>型号、速率和查询命令只用于串口测力计</translation>
    </message>
    <message>
        <source>serial:/dev/ttyUSB0</source>
        <translation>serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>it is not told where the force stands in the gauge&apos;s reports</source>
        <translation>没有说明力在测力计报告中的位置</translation>
    </message>
    <message>
        <source>a report is told of a gauge that is no HID device</source>
        <translation>为不是 HID 设备的测力计给出了报告描述</translation>
    </message>
    <message>
        <source>hid:DEVICE and &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;</source>
        <translation>hid:DEVICE 和 &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no gauge</source>
        <translation>“{}”不是测力计</translation>
    </message>
    <message>
        <source>typed, serial:/dev/ttyUSB0 or hid:DEVICE</source>
        <translation>typed、serial:/dev/ttyUSB0 或 hid:DEVICE</translation>
    </message>
    <message>
        <source>{} lines of the gauge were no readings</source>
        <translation>测力计有 {} 行不是读数</translation>
    </message>
    <message>
        <source>The gauge does not answer to &apos;{}&apos;. Try: another speed, another question, its settings for the serial line.</source>
        <translation>测力计对“{}”没有应答。建议：换一个速率，换一个查询命令，或检查其串口设置。</translation>
    </message>
    <message>
        <source>make this user a member of the group dialout (sudo usermod -aG dialout $USER) and log in again</source>
        <translation>将此用户加入 dialout 组（sudo usermod -aG dialout $USER），然后重新登录</translation>
    </message>
    <message>
        <source>another program uses it</source>
        <translation>另一程序正在使用它</translation>
    </message>
    <message>
        <source>close that program</source>
        <translation>关闭该程序</translation>
    </message>
    <message>
        <source>there is no such serial line</source>
        <translation>没有这样的串口</translation>
    </message>
    <message>
        <source>plug the gauge in; none was found</source>
        <translation>插上测力计；没有找到测力计</translation>
    </message>
    <message>
        <source>plug it in, or one of {}</source>
        <translation>插上它，或使用 {} 之一</translation>
    </message>
    <message>
        <source>the serial line is gone</source>
        <translation>串口已消失</translation>
    </message>
    <message>
        <source>plug the gauge in again</source>
        <translation>重新插上测力计</translation>
    </message>
    <message>
        <source>the serial line cannot be set up</source>
        <translation>无法设置串口</translation>
    </message>
    <message>
        <source>this is no serial line</source>
        <translation>这不是串口</translation>
    </message>
    <message>
        <source>the gauge&apos;s /dev/tty...</source>
        <translation>使用测力计的 /dev/tty...</translation>
    </message>
    <message>
        <source>the serial line does not take {} baud</source>
        <translation>串口不接受 {} 波特</translation>
    </message>
    <message>
        <source>the speed that the gauge&apos;s manual tells</source>
        <translation>使用测力计手册中给出的速率</translation>
    </message>
    <message>
        <source>{} baud is no speed of a serial line</source>
        <translation>{} 波特不是串口的速率</translation>
    </message>
    <message>
        <source>9600, 19200, 115200 or what the gauge&apos;s manual tells</source>
        <translation>9600、19200、115200，或测力计手册中给出的速率</translation>
    </message>
    <message>
        <source>the serial line cannot be opened</source>
        <translation>无法打开串口</translation>
    </message>
    <message>
        <source>the serial line takes nothing</source>
        <translation>串口不接收数据</translation>
    </message>
    <message>
        <source>check its cable</source>
        <translation>检查其电缆</translation>
    </message>
    <message>
        <source>{} from now on</source>
        <translation>从现在起为 {}</translation>
    </message>
    <message>
        <source>what was typed holds no longer</source>
        <translation>之前键入的内容不再有效</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no reading; a number, &apos;y 1.2 N&apos;, &apos;block NAME&apos;, or nothing</source>
        <translation>&apos;{}&apos; 不是读数；请键入一个数、&apos;y 1.2 N&apos;、&apos;block NAME&apos;，或什么都不键入</translation>
    </message>
    <message>
        <source>{:.3f} {:.3f} {:.3f} N</source>
        <translation>{:.3f} {:.3f} {:.3f} N</translation>
    </message>
    <message>
        <source>ours, simulated</source>
        <translation>本程序，仿真</translation>
    </message>
    <message>
        <source>paper, measured</source>
        <translation>论文，实测</translation>
    </message>
    <message>
        <source>Fx and Fy of pushes, on fingers drawn at random</source>
        <translation>推压的 Fx 和 Fy，手指随机抽取</translation>
    </message>
    <message>
        <source>place and force in rooms of 300, 1100 and 2500 lux</source>
        <translation>300、1100 和 2500 勒克斯的房间中的位置和力</translation>
    </message>
    <message>
        <source>Ours are simulated, with the truth known; the paper&apos;s were measured on a real finger.</source>
        <translation>本程序的为仿真值，真值已知；论文的是在真实手指上测得的。</translation>
    </message>
    <message>
        <source>least depth of a ball that is felt, ours alone</source>
        <translation>能感觉到的最小压球深度，仅本程序</translation>
    </message>
    <message>
        <source>place along the finger (mm)</source>
        <translation>沿手指的位置（mm）</translation>
    </message>
    <message>
        <source>least depth felt (mm)</source>
        <translation>能感觉到的最小深度（mm）</translation>
    </message>
    <message>
        <source>least force that is felt, on every face over height</source>
        <translation>每个面上能感觉到的最小力随高度的变化</translation>
    </message>
    <message>
        <source>least force felt (N)</source>
        <translation>能感觉到的最小力（N）</translation>
    </message>
    <message>
        <source>paper, at most, measured</source>
        <translation>论文，上限，实测</translation>
    </message>
    <message>
        <source>{} lux</source>
        <translation>{} 勒克斯</translation>
    </message>
    <message>
        <source>error of the place in rooms of different light; the paper tells no figure by room</source>
        <translation>不同光照的房间中的位置误差；论文没有按房间给出数字</translation>
    </message>
    <message>
        <source>mean error of the place (mm)</source>
        <translation>位置的平均误差（mm）</translation>
    </message>
    <message>
        <source>error of the force in rooms of different light, by a model that learnt in the dark</source>
        <translation>不同光照的房间中力的误差，所用模型在黑暗中训练</translation>
    </message>
    <message>
        <source>mean error of Fx and Fy (N)</source>
        <translation>Fx 和 Fy 的平均误差（N）</translation>
    </message>
    <message>
        <source>place, mean error at {} lux</source>
        <translation>位置，{} 勒克斯时的平均误差</translation>
    </message>
    <message>
        <source>force, mean error at {} lux</source>
        <translation>力，{} 勒克斯时的平均误差</translation>
    </message>
    <message>
        <source>place, greatest change between rooms</source>
        <translation>位置，房间之间的最大变化</translation>
    </message>
    <message>
        <source>force, greatest change between rooms</source>
        <translation>力，房间之间的最大变化</translation>
    </message>
    <message>
        <source>the same without correction of the light</source>
        <translation>同上，不作光照校正</translation>
    </message>
    <message>
        <source>How much of a room&apos;s light gets into a finger is a guess of the scene, 4 grey levels of a white surface for every 1000 lux; the same frames are shown in every room</source>
        <translation>有多少房间的光进入手指是场景的推测：每 1000 勒克斯使白色表面增加 4 个灰度级；每个房间中显示的是相同的帧</translation>
    </message>
    <message>
        <source>told right (%)</source>
        <translation>判断正确（%）</translation>
    </message>
    <message>
        <source>side of 8</source>
        <translation>8 个方向</translation>
    </message>
    <message>
        <source>how many frames have a reference closer than so many px, summed over the dots</source>
        <translation>参考距离（各点之和）小于相应 px 数的帧有多少</translation>
    </message>
    <message>
        <source>distance to the reference (px)</source>
        <translation>与参考的距离（px）</translation>
    </message>
    <message>
        <source>frames (%)</source>
        <translation>帧（%）</translation>
    </message>
    <message>
        <source>nearest of a recording, ours</source>
        <translation>录像中最近的，本程序</translation>
    </message>
    <message>
        <source>one reference, ours</source>
        <translation>单一参考，本程序</translation>
    </message>
    <message>
        <source>nearest, paper, measured</source>
        <translation>最近的，论文，实测</translation>
    </message>
    <message>
        <source>one, paper, measured</source>
        <translation>单一，论文，实测</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>无误差</translation>
    </message>
    <message>
        <source>held out, ours, simulated</source>
        <translation>留出，本程序，仿真</translation>
    </message>
    <message>
        <source>true force (N)</source>
        <translation>真实力（N）</translation>
    </message>
    <message>
        <source>told force (N)</source>
        <translation>得出的力（N）</translation>
    </message>
    <message>
        <source>mean error of the force, ours simulated and the paper&apos;s measured</source>
        <translation>力的平均误差，本程序为仿真，论文为实测</translation>
    </message>
    <message>
        <source>mean error (N)</source>
        <translation>平均误差（N）</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Fy</source>
        <translation>Fy</translation>
    </message>
    <message>
        <source>aim</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>where along the finger the error is: the base moves the markers least</source>
        <translation>误差在手指上的分布：根部使标记点移动得最少</translation>
    </message>
    <message>
        <source>Fx, ours</source>
        <translation>Fx，本程序</translation>
    </message>
    <message>
        <source>Fy, ours</source>
        <translation>Fy，本程序</translation>
    </message>
    <message>
        <source>Fx, paper, over all places</source>
        <translation>Fx，论文，全部位置</translation>
    </message>
    <message>
        <source>Fy, paper, over all places</source>
        <translation>Fy，论文，全部位置</translation>
    </message>
    <message>
        <source>Fx told of places that were held out</source>
        <translation>在留出的位置上得出的 Fx</translation>
    </message>
    <message>
        <source>Fy told of places that were held out</source>
        <translation>在留出的位置上得出的 Fy</translation>
    </message>
    <message>
        <source>Fx, mean error on places held out</source>
        <translation>Fx，留出位置上的平均误差</translation>
    </message>
    <message>
        <source>Fy, mean error on places held out</source>
        <translation>Fy，留出位置上的平均误差</translation>
    </message>
    <message>
        <source>Fx, the same of the worst finger</source>
        <translation>Fx，同上，最差的手指</translation>
    </message>
    <message>
        <source>Fy, the same of the worst finger</source>
        <translation>Fy，同上，最差的手指</translation>
    </message>
    <message>
        <source>forces within their intervals of 95 %</source>
        <translation>落在其 95 % 区间内的力</translation>
    </message>
    <message>
        <source>the same, away from 95 %</source>
        <translation>同上，与 95 % 的偏差</translation>
    </message>
    <message>
        <source>{} fingers drawn at random, 484 pushes each at {} places, of which whole ones are held out; {} pushes are measured, in the others too few markers are found. Forces are those on the finger in the camera&apos;s axes and have no error of a gauge</source>
        <translation>随机抽取 {} 个手指，每个在 {} 个位置上推压 484 次，其中有整个位置被留出；测得 {} 次推压，其余的找到的标记点太少。力是作用在手指上的力，以相机坐标轴表示，不含测力计的误差</translation>
    </message>
    <message>
        <source>Nothing drags along the finger: that hardly moves a marker, and is told by none</source>
        <translation>没有沿手指方向的拉力：它几乎不使标记点移动，也没有标记点能反映它</translation>
    </message>
    <message>
        <source>error of the relief, ours alone: the paper shows pictures</source>
        <translation>浮雕的误差，仅本程序：论文给出的是图片</translation>
    </message>
    <message>
        <source>mean depth error (mm)</source>
        <translation>平均深度误差（mm）</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>伸直</translation>
    </message>
    <message>
        <source>bent</source>
        <translation>弯曲</translation>
    </message>
    <message>
        <source>time of a frame&apos;s steps, ours on this computer and the paper&apos;s on its own</source>
        <translation>一帧各步骤的用时，本程序在本计算机上，论文在其自己的计算机上</translation>
    </message>
    <message>
        <source>time (ms)</source>
        <translation>时间（ms）</translation>
    </message>
    <message>
        <source>edges, shape</source>
        <translation>边缘，形状</translation>
    </message>
    <message>
        <source>markers, reference</source>
        <translation>标记点，参考</translation>
    </message>
    <message>
        <source>depth, contacts</source>
        <translation>深度，接触</translation>
    </message>
    <message>
        <source>whole frame</source>
        <translation>整帧</translation>
    </message>
    <message>
        <source>error of the place along the finger, one point a touch</source>
        <translation>沿手指的位置误差，每次触碰一个点</translation>
    </message>
    <message>
        <source>error of the place (mm)</source>
        <translation>位置误差（mm）</translation>
    </message>
    <message>
        <source>paper, mean within 20 mm of the middle, measured</source>
        <translation>论文，中部 20 mm 内的平均值，实测</translation>
    </message>
    <message>
        <source>paper, mean at the tip, measured</source>
        <translation>论文，指尖处的平均值，实测</translation>
    </message>
    <message>
        <source>error of the angle of a bar, by how it is turned</source>
        <translation>杆的角度误差随其转角的变化</translation>
    </message>
    <message>
        <source>true angle (degrees)</source>
        <translation>真实角度（度）</translation>
    </message>
    <message>
        <source>error of the angle (degrees)</source>
        <translation>角度误差（度）</translation>
    </message>
    <message>
        <source>paper, the lesser, measured</source>
        <translation>论文，较小者，实测</translation>
    </message>
    <message>
        <source>paper, the greater, measured</source>
        <translation>论文，较大者，实测</translation>
    </message>
    <message>
        <source>the finger is not calibrated</source>
        <translation>手指尚未标定</translation>
    </message>
    <message>
        <source>calibrating it with ball presses</source>
        <translation>用球按压标定它</translation>
    </message>
    <message>
        <source>this is not the report of the finger&apos;s calibration</source>
        <translation>这不是该手指标定的报告</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; counts in no unit of force</source>
        <translation>列 &apos;{}&apos; 的单位不是力的单位</translation>
    </message>
    <message>
        <source>pressing in different directions; several tables may be given</source>
        <translation>向不同方向按压；可以给出多个表</translation>
    </message>
    <message>
        <source>The gauge tells {:.0f} ms (sd {:.0f} ms) after the pictures; that is taken out.</source>
        <translation>测力计的读数比图片晚 {:.0f} ms（标准差 {:.0f} ms）；已作扣除。</translation>
    </message>
    <message>
        <source>The gauge tells {:.0f} ms (sd {:.0f} ms) before the pictures; that is taken out.</source>
        <translation>测力计的读数比图片早 {:.0f} ms（标准差 {:.0f} ms）；已作扣除。</translation>
    </message>
    <message>
        <source>How late the gauge tells could not be told from these frames: nothing is taken out. Try: some quick taps while recording.</source>
        <translation>无法由这些帧得出测力计滞后多少：未作任何扣除。建议：录制时快速轻触几次。</translation>
    </message>
    <message>
        <source>The gauge and the camera were on different clocks: {:.3f} s (sd {:.3f} s) apart by the markers&apos; motion, drifting by {:.0f} ppm.</source>
        <translation>测力计和相机使用不同的时钟：按标记点的运动，两者相差 {:.3f} s（标准差 {:.3f} s），漂移 {:.0f} ppm。</translation>
    </message>
    <message>
        <source>has {} markers and {} axes, the tables before it {} and {}</source>
        <translation>有 {} 个标记点和 {} 个轴，而之前的表有 {} 个和 {} 个</translation>
    </message>
    <message>
        <source>tables of one finger and one kind of gauge</source>
        <translation>使用同一手指、同一种测力计的表</translation>
    </message>
    <message>
        <source>pressing the ball in deeper, whole on the face</source>
        <translation>把球压得更深，并使其完全在面上</translation>
    </message>
    <message>
        <source>nothing is dark enough for a ball that presses</source>
        <translation>没有暗到足以表明有球压入的部分</translation>
    </message>
    <message>
        <source>no circle gives a cubic whose constant is zero</source>
        <translation>没有圆能得出常数项为零的三次曲线</translation>
    </message>
    <message>
        <source>the cubic without a constant leaves {:.0f} % of the depths&apos; spread: its contact is too faint, small or steep</source>
        <translation>不含常数项的三次曲线留下深度离散的 {:.0f} %：接触太弱、太小或太陡</translation>
    </message>
    <message>
        <source>stopped before the first solution</source>
        <translation>得到第一个解之前已停止</translation>
    </message>
    <message>
        <source>the source paper&apos;s method finds a ball in none of {} presses ({})</source>
        <translation>原论文的方法在 {} 次按压中都找不到球（{}）</translation>
    </message>
    <message>
        <source>there is none that is not excluded</source>
        <translation>没有未被排除的按压</translation>
    </message>
    <message>
        <source>the source paper&apos;s method can measure none of {} presses ({})</source>
        <translation>原论文的方法无法测量 {} 次按压中的任何一次（{}）</translation>
    </message>
    <message>
        <source>our own method</source>
        <translation>使用本程序自己的方法</translation>
    </message>
    <message>
        <source>the source paper&apos;s method calibrates in its own way, and this finger keeps no presses to do so with</source>
        <translation>原论文的方法以自己的方式标定，而此手指没有保存可用于此的按压</translation>
    </message>
    <message>
        <source>alltact calibrate with ball presses</source>
        <translation>用球按压运行 alltact calibrate</translation>
    </message>
    <message>
        <source>stopped before the study was over</source>
        <translation>研究完成前已停止</translation>
    </message>
    <message>
        <source>measuring what settings cost</source>
        <translation>正在测量各设置的代价</translation>
    </message>
    <message>
        <source>too few pictures of the reference recording show the face</source>
        <translation>参考录像中显示面的图片太少</translation>
    </message>
    <message>
        <source>record the finger bending through all its poses</source>
        <translation>录制手指弯曲经过其所有姿态的过程</translation>
    </message>
    <message>
        <source>balls painted into untouched pictures of {}</source>
        <translation>画入 {} 的未触碰图片中的球</translation>
    </message>
    <message>
        <source>the demonstration&apos;s finger, simulated, pressed in random places</source>
        <translation>演示的手指，仿真，在随机位置按压</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>is not what a study of this program keeps</source>
        <translation>不是本程序的研究所保存的内容</translation>
    </message>
    <message>
        <source>remove it, and the study begins anew</source>
        <translation>删除它，研究将重新开始</translation>
    </message>
    <message>
        <source>the gripper&apos;s fingers are {} and {}, and others are open</source>
        <translation>夹爪的手指是 {} 和 {}，而打开的是其他手指</translation>
    </message>
    <message>
        <source>opening these two fingers</source>
        <translation>打开这两个手指</translation>
    </message>
    <message>
        <source>unexpected: {}</source>
        <translation>意外错误：{}</translation>
    </message>
    <message>
        <source>reporting this as a defect</source>
        <translation>将此作为缺陷报告</translation>
    </message>
    <message>
        <source>a line of it is damaged</source>
        <translation>其中有一行已损坏</translation>
    </message>
    <message>
        <source>reconstruct this part again</source>
        <translation>再次重建这一部分</translation>
    </message>
    <message>
        <source>the part is damaged or cut short</source>
        <translation>该部分已损坏或不完整</translation>
    </message>
    <message>
        <source>these are parts of two different runs: {} and {}</source>
        <translation>这些部分来自两次不同的运行：{} 和 {}</translation>
    </message>
    <message>
        <source>the folders of one run, or reconstruct all its parts again</source>
        <translation>使用同一次运行的文件夹，或再次重建其所有部分</translation>
    </message>
    <message>
        <source>part {} is there twice: {} and {}</source>
        <translation>第 {} 部分有两份：{} 和 {}</translation>
    </message>
    <message>
        <source>there are no parts of a reconstruction</source>
        <translation>没有重建的任何部分</translation>
    </message>
    <message>
        <source>alltact reconstruct with --shard 1/N to N/N first</source>
        <translation>先用 --shard 1/N 到 N/N 运行 alltact reconstruct</translation>
    </message>
    <message>
        <source>of {} parts these are missing: {}</source>
        <translation>共 {} 个部分，缺少：{}</translation>
    </message>
    <message>
        <source>reconstruct these parts, too</source>
        <translation>把这些部分也重建</translation>
    </message>
    <message>
        <source>the part was stopped after {} of {} frames</source>
        <translation>该部分处理了 {} 帧（共 {} 帧）后被中止</translation>
    </message>
    <message>
        <source>the file cannot be moved: {}</source>
        <translation>无法移动文件：{}</translation>
    </message>
    <message>
        <source>free some space, or ask the folder&apos;s owner for access</source>
        <translation>腾出空间，或向文件夹的所有者申请权限</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no part of a whole</source>
        <translation>&apos;{}&apos; 不表示整体的一部分</translation>
    </message>
    <message>
        <source>1/8 to 8/8 for eight parts, for example</source>
        <translation>例如分成八个部分时用 1/8 到 8/8</translation>
    </message>
    <message>
        <source>could not make sure that the files are on the disk</source>
        <translation>无法确认文件已写到磁盘</translation>
    </message>
    <message>
        <source>the picture does not say that it holds depth in 16 bits</source>
        <translation>图片没有注明它含有 16 位深度</translation>
    </message>
    <message>
        <source>a picture of alltact reconstruct --format depth16</source>
        <translation>使用 alltact reconstruct --format depth16 的图片</translation>
    </message>
    <message>
        <source>the part of the face that depth is told of, in millimetres along it from its base; all else counts as off the face</source>
        <translation>给出深度的那一部分面，从根部起沿面以毫米计；其余都视为不在面上</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not &apos;all&apos; or a part of the face in mm such as 20-60</source>
        <translation>&apos;{}&apos; 既不是 &apos;all&apos;，也不是以 mm 计的面的一部分，如 20-60</translation>
    </message>
    <message>
        <source>pixels that a picture is measured with: all of them, or means of 2 by 2 or 4 by 4 of them; results in pixels are then of that picture</source>
        <translation>测量图像所用的像素：全部，或每 2×2 或 4×4 个的平均；以像素计的结果则以该图像为准</translation>
    </message>
    <message>
        <source>&apos;whole&apos; tells small contacts and steep edges, and numbers small dots</source>
        <translation>&apos;whole&apos; 能识别小的接触和陡的边缘，并能给小的标记点编号</translation>
    </message>
    <message>
        <source>&apos;half&apos; is a quarter of the pixels and of the recording&apos;s memory, &apos;quarter&apos; a sixteenth</source>
        <translation>&apos;half&apos; 的像素和录像所占内存为四分之一，&apos;quarter&apos; 为十六分之一</translation>
    </message>
    <message>
        <source>pictures of one source whose running mean is measured; 1: each by itself. A finger that moves is then seen where it was on average, and blurred</source>
        <translation>取滑动平均后再测量的同一来源的图像数；1：逐张测量。运动中的手指则显示在其平均位置上，而且模糊</translation>
    </message>
    <message>
        <source>more quiet the noise of a finger that holds still, by their square root</source>
        <translation>越多，静止手指的噪声越小，按数目的平方根降低</translation>
    </message>
    <message>
        <source>more tell of the finger later, by half of them; adding them up takes a little</source>
        <translation>越多，手指的结果越滞后，滞后为其数目的一半；累加要花少许时间</translation>
    </message>
    <message>
        <source>&apos;all&apos; misses no contact</source>
        <translation>&apos;all&apos; 不会漏掉任何接触</translation>
    </message>
    <message>
        <source>depth takes as much less time as the part is shorter than the face</source>
        <translation>该部分比整个面短多少，计算深度就省多少时间</translation>
    </message>
    <message>
        <source>recorded pictures that reference-method local computes the reference from</source>
        <translation>reference-method local 计算参考所用的录制图片数</translation>
    </message>
    <message>
        <source>more leave less noise in the reference; too many reach too far from the pose</source>
        <translation>越多，参考中的噪声越少；过多则离当前姿态太远</translation>
    </message>
    <message>
        <source>each is added up in every frame</source>
        <translation>每一张都要在每一帧中累加</translation>
    </message>
    <message>
        <source>no plane goes through so few measured pixels, or through one line</source>
        <translation>测得的像素太少或都在一条线上，无法确定平面</translation>
    </message>
    <message>
        <source>a larger piece, or one that is measured</source>
        <translation>使用更大的区域，或有测量值的区域</translation>
    </message>
    <message>
        <source>{} measured pixels where {} are needed</source>
        <translation>测得 {} 个像素，需要 {} 个</translation>
    </message>
    <message>
        <source>no ball lies in this piece</source>
        <translation>此区域中没有球</translation>
    </message>
    <message>
        <source>a piece that is round, seen up to where it is half as deep</source>
        <translation>使用圆形的区域，且看得见到深度减半处</translation>
    </message>
    <message>
        <source>nothing here is deeper than {} mm</source>
        <translation>此处没有任何地方深于 {} mm</translation>
    </message>
    <message>
        <source>a piece where something presses</source>
        <translation>使用有物体压入的区域</translation>
    </message>
    <message>
        <source>the piece is too narrow to take its form out</source>
        <translation>区域太窄，无法扣除其形状</translation>
    </message>
    <message>
        <source>a wider one</source>
        <translation>使用更宽的区域</translation>
    </message>
    <message>
        <source>no step along this line stands out of the noise</source>
        <translation>沿此线没有高出噪声的台阶</translation>
    </message>
    <message>
        <source>a line that crosses the step at a right angle</source>
        <translation>使用与台阶成直角相交的线</translation>
    </message>
    <message>
        <source>a part of this piece is at a limit of what is measured</source>
        <translation>这一块的一部分处于测量极限</translation>
    </message>
    <message>
        <source>a piece that is pressed in less deep</source>
        <translation>请选择压入较浅的一块</translation>
    </message>
    <message>
        <source>one side of the step is too short to be a plane</source>
        <translation>台阶的一侧太短，不足以构成平面</translation>
    </message>
    <message>
        <source>a line that reaches further over both sides</source>
        <translation>请让连线在两侧都延伸得更远</translation>
    </message>
    <message>
        <source>one side of the step is not plane</source>
        <translation>台阶的一侧不是平面</translation>
    </message>
    <message>
        <source>a line over two planes, with the step between them</source>
        <translation>请让连线跨过两个平面，台阶位于其间</translation>
    </message>
    <message>
        <source>both sides of the step are not parallel</source>
        <translation>台阶的两侧不平行</translation>
    </message>
    <message>
        <source>a line over two parallel planes, with the step between them</source>
        <translation>请让连线跨过两个平行平面，台阶位于其间</translation>
    </message>
    <message>
        <source>could not keep the simulated finger for the next time</source>
        <translation>无法保存仿真手指供下次使用</translation>
    </message>
    <message>
        <source>error of a push&apos;s direction in the picture; sides begin at 22.5 degrees and every 45 from there, and the paper tells no figure of it</source>
        <translation>图像中推压方向的误差；各方向的分界始于 22.5 度，此后每 45 度一个，论文未给出此项数字</translation>
    </message>
    <message>
        <source>true direction (degrees)</source>
        <translation>真实方向（度）</translation>
    </message>
    <message>
        <source>error of the direction (degrees)</source>
        <translation>方向误差（度）</translation>
    </message>
    <message>
        <source>frames under 10 px a dot, or told to be in a pose never recorded</source>
        <translation>每点低于 10 px 的帧，或被报告为姿态从未录制过的帧</translation>
    </message>
    <message>
        <source>frames under 10 px summed over the dots, nearest of a recording</source>
        <translation>各点之和低于 10 px 的帧，录像中最近的一帧</translation>
    </message>
    <message>
        <source>the same, of the recorded frames as the reference combines them</source>
        <translation>同上，录制的帧按参考的方式组合</translation>
    </message>
    <message>
        <source>the same, or told that the pose or its surroundings were not recorded</source>
        <translation>同上，或被报告为该姿态或其附近未录制过</translation>
    </message>
    <message>
        <source>as the reference combines them, ours</source>
        <translation>按参考的方式组合，本程序</translation>
    </message>
    <message>
        <source>The paper sums the distance over its dots, and under 40 px is told so here; under 10 px is told over this finger and {} drawn at random, for a dot and summed</source>
        <translation>论文把距离对其各点求和，这里的“小于 40 px”也这样给出；“小于 10 px”则按此手指和随机抽取的 {} 个手指给出，分别为每点的值和总和</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>真值</translation>
    </message>
    <message>
        <source>relief of the straight finger, as the pressed face lies from base (left) to tip</source>
        <translation>伸直手指的浮雕，按被压面从根部（左）到指尖的方向</translation>
    </message>
    <message>
        <source>relief of the bent finger, as the pressed face lies from base (left) to tip</source>
        <translation>弯曲手指的浮雕，按被压面从根部（左）到指尖的方向</translation>
    </message>
    <message>
        <source>recording of all poses</source>
        <translation>全部姿态的录像</translation>
    </message>
    <message>
        <source>recording of all poses, error</source>
        <translation>全部姿态的录像，误差</translation>
    </message>
    <message>
        <source>single reference</source>
        <translation>单一参考</translation>
    </message>
    <message>
        <source>single reference, error</source>
        <translation>单一参考，误差</translation>
    </message>
    <message>
        <source>The paper shows pictures of reliefs and no figure; both of ours use the same calibration, so that only the reference differs</source>
        <translation>论文给出浮雕的图片，没有数字；本程序的两个结果使用同一标定，因此只有参考不同</translation>
    </message>
    <message>
        <source>no finger was given that measures these pictures</source>
        <translation>没有给出用来测量这些图片的手指</translation>
    </message>
    <message>
        <source>the scene shows another finger than {}</source>
        <translation>场景中的手指不是 {}</translation>
    </message>
    <message>
        <source>{} is not calibrated</source>
        <translation>{} 尚未标定</translation>
    </message>
    <message>
        <source>leaving out {}</source>
        <translation>正在去掉 {}</translation>
    </message>
    <message>
        <source>ours, on this computer</source>
        <translation>本程序，在这台计算机上</translation>
    </message>
    <message>
        <source>the worst of {} fingers drawn at random, within +-20 mm</source>
        <translation>随机抽取的 {} 个手指中最差的，+-20 mm 内</translation>
    </message>
    <message>
        <source>the worst of {} fingers drawn at random, at the tip</source>
        <translation>随机抽取的 {} 个手指中最差的，指尖处</translation>
    </message>
    <message>
        <source>is no setting of this version</source>
        <translation>不是此版本的设置</translation>
    </message>
    <message>
        <source>a new study</source>
        <translation>重新进行一次研究</translation>
    </message>
    <message>
        <source>studying the finger again</source>
        <translation>重新研究此手指</translation>
    </message>
    <message>
        <source>this finger keeps no presets: it was not studied yet</source>
        <translation>此手指没有预设：尚未对它进行研究</translation>
    </message>
    <message>
        <source>alltact study {} --save</source>
        <translation>alltact study {} --save</translation>
    </message>
    <message>
        <source>nothing is faster on this finger without being half as wrong again</source>
        <translation>在此手指上，没有哪种设置更快而误差不增大一半</translation>
    </message>
    <message>
        <source>nothing is more accurate on this finger than how it was calibrated</source>
        <translation>在此手指上，没有比标定时所用设置更精确的</translation>
    </message>
    <message>
        <source>measuring with {}</source>
        <translation>用 {} 测量</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no preset of this finger</source>
        <translation>“{}”不是此手指的预设</translation>
    </message>
    <message>
        <source>{}</source>
        <translation>{}</translation>
    </message>
    <message>
        <source>beyond the {} that are to be used</source>
        <translation>超出要使用的 {} 次</translation>
    </message>
    <message>
        <source>presses that are used at most, spread evenly over those given; 0: all of them</source>
        <translation>最多使用的按压次数，在所给按压中均匀选取；0：全部</translation>
    </message>
    <message>
        <source>more hold the curve at more depths and places; ten well spread are usual</source>
        <translation>越多，曲线就在越多的深度和位置上有依据；通常用十次分布良好的按压</translation>
    </message>
    <message>
        <source>each has to be made, and is left out once to see what it predicts</source>
        <translation>每次都要实际按压，并会被留出一次以检验预测</translation>
    </message>
    <message>
        <source>pictures of a press held still (--bursts) that are averaged at most</source>
        <translation>一次保持静止的按压（--bursts）最多取平均的图片数</translation>
    </message>
    <message>
        <source>more leave less noise in a press, by their square root</source>
        <translation>越多则一次按压中的噪声越小，与张数的平方根成反比</translation>
    </message>
    <message>
        <source>the ball has to be held still for so long, and reading them takes a little</source>
        <translation>球须保持静止相应的时间，读取图片也要花一点时间</translation>
    </message>
    <message>
        <source>rounds of the joint fit at most; it ends before when nothing moves any more</source>
        <translation>联合拟合的最多轮数；不再有变化时会提前结束</translation>
    </message>
    <message>
        <source>more settle what presses say against each other; too few leave the curve where it began</source>
        <translation>越多越能调和各次按压之间的矛盾；太少则曲线停留在起点</translation>
    </message>
    <message>
        <source>each solves all presses together once, in every trial</source>
        <translation>每一轮都在每次试验中把全部按压一起求解一次</translation>
    </message>
    <message>
        <source>the presses do not tell whether brightness follows the layer&apos;s thickness along its normal ({:.4f} mm on presses left out) or along z ({:.4f} mm): the normal is taken, and if that is wrong, places on the face lie {:.1f} mm off along it; larger pictures tell, and presses where the face is steep and where it is flat</source>
        <translation>按压无法说明亮度是随层沿法线的厚度变化（留出按压误差 {:.4f} mm），还是随沿 z 的厚度变化（{:.4f} mm）：现取法线，若这不对，面上的位置会沿法线偏 {:.1f} mm；更大的图片以及在面的陡处和平处的按压可以说明</translation>
    </message>
    <message>
        <source>the source paper&apos;s method is not studied with a turned camera</source>
        <translation>不研究相机转动时的原论文方法</translation>
    </message>
    <message>
        <source>{}: depth {:.1f} instead of {:.1f} micrometres off in the median, 95 % within {:.1f} instead of {:.1f}, for {:.1f} minutes more</source>
        <translation>{}：深度误差中位数为 {:.1f} 而不是 {:.1f} 微米，95 % 在 {:.1f} 而不是 {:.1f} 以内，多用 {:.1f} 分钟</translation>
    </message>
    <message numerus="yes">
        <source>{} presses</source>
        <comment>{} press</comment>
        <translation>
            <numerusform>{} 次按压</numerusform>
        </translation>
    </message>
    <message>
        <source>{} pictures each</source>
        <translation>每次 {} 张图片</translation>
    </message>
    <message>
        <source>method {}</source>
        <translation>方法 {}</translation>
    </message>
    <message>
        <source>family {}</source>
        <translation>曲线种类 {}</translation>
    </message>
    <message numerus="yes">
        <source>{} presses more</source>
        <comment>{} press more</comment>
        <translation>
            <numerusform>多 {} 次按压</numerusform>
        </translation>
    </message>
    <message>
        <source>{} pictures of each press</source>
        <translation>每次按压 {} 张图片</translation>
    </message>
    <message>
        <source>The best within a minute more ({})</source>
        <translation>多用不超过一分钟时的最佳选择（{}）</translation>
    </message>
    <message>
        <source>the finger keeps too few presses to leave one out: {}</source>
        <translation>手指保存的按压太少，无法留出一次：{}</translation>
    </message>
    <message>
        <source>calibrating it with three presses or more</source>
        <translation>用三次或更多按压标定它</translation>
    </message>
    <message>
        <source>calibrating {} anew</source>
        <translation>重新标定 {}</translation>
    </message>
    <message>
        <source>calibrating with {}</source>
        <translation>正在标定：{}</translation>
    </message>
    <message>
        <source>none of {} presses could be held against a mapping made without it</source>
        <translation>{} 次按压中，没有一次能与未使用它的映射作比较</translation>
    </message>
    <message>
        <source>more presses of different depth</source>
        <translation>更多不同深度的按压</translation>
    </message>
    <message>
        <source>leaving out presses, {} of {}</source>
        <translation>正在逐一留出按压，第 {} / {} 次</translation>
    </message>
    <message>
        <source>{}, {:.0f} s left</source>
        <translation>{}，还剩 {:.0f} 秒</translation>
    </message>
    <message>
        <source>{}, {:.0f} min left</source>
        <translation>{}，还剩 {:.0f} 分钟</translation>
    </message>
    <message>
        <source>takes {:.2f} times as long</source>
        <translation>用时为 {:.2f} 倍</translation>
    </message>
    <message>
        <source>depth {:.1f} instead of {:.1f} micrometres off</source>
        <translation>深度误差为 {:.1f} 而不是 {:.1f} 微米</translation>
    </message>
    <message>
        <source>95 % of depth within {:.1f} instead of {:.1f} micrometres</source>
        <translation>95 % 的深度误差在 {:.1f} 而不是 {:.1f} 微米以内</translation>
    </message>
    <message>
        <source>places told {:.3f} instead of {:.3f} mm off</source>
        <translation>位置误差为 {:.3f} 而不是 {:.3f} mm</translation>
    </message>
    <message>
        <source>angles told {:.1f} instead of {:.1f} degrees off</source>
        <translation>角度误差为 {:.1f} 而不是 {:.1f} 度</translation>
    </message>
    <message>
        <source>{:.1f} instead of {:.1f} micrometres of false depth</source>
        <translation>虚假深度为 {:.1f} 而不是 {:.1f} 微米</translation>
    </message>
    <message numerus="yes">
        <source>no depth in {} pictures</source>
        <comment>no depth in {} picture</comment>
        <translation>
            <numerusform>{} 张图片中没有深度</numerusform>
        </translation>
    </message>
    <message>
        <source>the figure cannot be drawn</source>
        <translation>无法绘制图表</translation>
    </message>
    <message>
        <source>the part&apos;s video of depth is missing</source>
        <translation>该部分的深度视频缺失</translation>
    </message>
    <message>
        <source>could not compress the depth</source>
        <translation>无法压缩深度</translation>
    </message>
    <message>
        <source>the video does not say that it holds depth</source>
        <translation>视频没有说明它包含深度</translation>
    </message>
    <message>
        <source>a video of alltact reconstruct --format depth-video</source>
        <translation>使用 alltact reconstruct --format depth-video 写出的视频</translation>
    </message>
    <message>
        <source>the video of depth is damaged or cut short</source>
        <translation>深度视频已损坏或被截断</translation>
    </message>
    <message>
        <source>reconstruct the recording again</source>
        <translation>重新重建该录像</translation>
    </message>
    <message>
        <source>this system&apos;s libavcodec cannot write FFV1</source>
        <translation>此系统的 libavcodec 无法写 FFV1</translation>
    </message>
    <message>
        <source>Debian&apos;s libavcodec, or depth as single pictures</source>
        <translation>使用 Debian 的 libavcodec，或把深度存为单张图片</translation>
    </message>
    <message>
        <source>whether what the lens bends is taken out of every point, or the lens is taken as one that bends nothing</source>
        <translation>是否从每个点中消除镜头的畸变，或将镜头视为无畸变</translation>
    </message>
    <message>
        <source>&apos;exact&apos; tells shape and places right up to the picture&apos;s corners</source>
        <translation>&apos;exact&apos; 直到图像角落都能正确给出形状和位置</translation>
    </message>
    <message>
        <source>&apos;exact&apos; looks each ray up by itself</source>
        <translation>&apos;exact&apos; 逐条查找每条光线</translation>
    </message>
    <message>
        <source>how a layer pressed in along its normal is told along z: looked up where the normal leads, or at the same pixel as if all rays were parallel</source>
        <translation>沿法线压入的层如何沿 z 给出：沿法线所指处查找，或视所有光线为平行而取同一像素</translation>
    </message>
    <message>
        <source>&apos;exact&apos; tells a contact on a sloping face where it is and as deep as it is; &apos;parallel&apos; up to a layer&apos;s thickness beside</source>
        <translation>&apos;exact&apos; 给出斜面上接触的真实位置和深度；&apos;parallel&apos; 的偏差可达一个层厚</translation>
    </message>
    <message>
        <source>&apos;exact&apos; looks every pixel of a contact up once more</source>
        <translation>&apos;exact&apos; 对接触的每个像素再查找一次</translation>
    </message>
    <message>
        <source>pixels from one vertex to the next in surfaces that are saved or shown in 3D; 1: every pixel</source>
        <translation>保存或以 3D 显示的曲面中，相邻顶点之间的像素数；1：每个像素</translation>
    </message>
    <message>
        <source>1 keeps every edge that was measured</source>
        <translation>1 保留测得的每条边缘</translation>
    </message>
    <message>
        <source>time and size fall with its square</source>
        <translation>时间和大小随其平方减小</translation>
    </message>
    <message>
        <source>a point lies off the face</source>
        <translation>有一个点不在面上</translation>
    </message>
    <message>
        <source>points on the face</source>
        <translation>使用面上的点</translation>
    </message>
    <message>
        <source>both points are one</source>
        <translation>两个点是同一点</translation>
    </message>
    <message>
        <source>two points that are apart</source>
        <translation>使用两个分开的点</translation>
    </message>
    <message>
        <source>the connection&apos;s line was not whole</source>
        <translation>连接的请求行不完整</translation>
    </message>
    <message>
        <source>ending it with a line break</source>
        <translation>以换行结束它</translation>
    </message>
    <message>
        <source>something came after the line</source>
        <translation>请求行之后还有内容</translation>
    </message>
    <message>
        <source>connecting again</source>
        <translation>重新连接</translation>
    </message>
    <message>
        <source>the line is longer than {} bytes</source>
        <translation>请求行超过 {} 字节</translation>
    </message>
    <message>
        <source>one line such as alltact-stream/1 picture depth16</source>
        <translation>使用如 alltact-stream/1 picture depth16 的一行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not ask for {}</source>
        <translation>“{}”没有请求 {}</translation>
    </message>
    <message>
        <source>there is no part &apos;{}&apos;, but {}</source>
        <translation>没有“{}”这一部分，只有 {}</translation>
    </message>
    <message>
        <source>another user&apos;s programs are not let in</source>
        <translation>不接受其他用户的程序</translation>
    </message>
    <message>
        <source>{} programs are served already</source>
        <translation>已有 {} 个程序在接收</translation>
    </message>
    <message>
        <source>ending one of them</source>
        <translation>结束其中一个</translation>
    </message>
    <message>
        <source>no line came within {} seconds</source>
        <translation>{} 秒内没有收到请求行</translation>
    </message>
    <message>
        <source>programs could not be let in here</source>
        <translation>无法在此接受程序连接</translation>
    </message>
    <message>
        <source>the path is longer than the {} bytes that a socket&apos;s may have</source>
        <translation>路径超过套接字允许的 {} 字节</translation>
    </message>
    <message>
        <source>a shorter one with --socket</source>
        <translation>用 --socket 指定更短的路径</translation>
    </message>
    <message>
        <source>this folder belongs to somebody else, who could read along</source>
        <translation>此文件夹属于他人，他人可能会读取</translation>
    </message>
    <message>
        <source>a folder of your own with --socket</source>
        <translation>用 --socket 指定自己的文件夹</translation>
    </message>
    <message>
        <source>others may write in this folder, and could put their own socket there</source>
        <translation>其他人可以写入此文件夹，可能放入他们自己的套接字</translation>
    </message>
    <message>
        <source>chmod 700, or another folder with --socket</source>
        <translation>使用 chmod 700，或用 --socket 指定其他文件夹</translation>
    </message>
    <message>
        <source>there is something here that is no socket, and it is left alone</source>
        <translation>此处有不是套接字的内容，未作改动</translation>
    </message>
    <message>
        <source>another path with --socket</source>
        <translation>用 --socket 指定其他路径</translation>
    </message>
    <message>
        <source>another program serves here already ({})</source>
        <translation>已有另一个程序在此提供服务 ({})</translation>
    </message>
    <message>
        <source>connecting to that one, ending it, or another path with --socket</source>
        <translation>连接到该程序、结束它，或用 --socket 指定其他路径</translation>
    </message>
    <message>
        <source>a file that a 3D program shows</source>
        <translation>使用 3D 程序能显示的文件</translation>
    </message>
    <message>
        <source>a file that ends in .ply, .vtp, .glb, .stl or .obj</source>
        <translation>使用以 .ply、.vtp、.glb、.stl 或 .obj 结尾的文件</translation>
    </message>
    <message>
        <source>these are points, no depth</source>
        <translation>这些是点，不是深度</translation>
    </message>
    <message>
        <source>NAME.depth.tiff</source>
        <translation>NAME.depth.tiff</translation>
    </message>
    <message>
        <source>the edges at the {} are not seen</source>
        <translation>看不到{}处的边缘</translation>
    </message>
    <message>
        <source>bring the whole face into the picture, lit, with dark beside it</source>
        <translation>让整个面进入图像并被照亮，旁边为暗</translation>
    </message>
    <message>
        <source>edges at the {} are {:.1f} px wide</source>
        <translation>{}处的边缘宽 {:.1f} px</translation>
    </message>
    <message>
        <source>turn the lens until the {} is sharp, and let the other end stay so</source>
        <translation>转动镜头直到{}清晰，并使另一端保持清晰</translation>
    </message>
    <message>
        <source>no face is seen</source>
        <translation>看不到面</translation>
    </message>
    <message>
        <source>{:.1f} % of the face are too bright to measure</source>
        <translation>面的 {:.1f} % 太亮，无法测量</translation>
    </message>
    <message>
        <source>dim the lamp, or shorten the exposure</source>
        <translation>调暗灯，或缩短曝光</translation>
    </message>
    <message>
        <source>the face is {:.0f} of 255 bright, nothing is too bright</source>
        <translation>面的亮度为 {:.0f} / 255，没有过亮处</translation>
    </message>
    <message>
        <source>turn the lamp up, or lengthen the exposure</source>
        <translation>调亮灯，或延长曝光</translation>
    </message>
    <message>
        <source>hold the finger still: {:.0f} of {:.0f} s</source>
        <translation>请保持手指不动：{:.0f} / {:.0f} s</translation>
    </message>
    <message>
        <source>brightness changes by {:.1f} % in {:.0f} s</source>
        <translation>亮度变化 {:.1f} %（{:.0f} s 内）</translation>
    </message>
    <message>
        <source>let the lamp warm up for ten minutes, shade the finger from the room&apos;s light, and lock the brightness</source>
        <translation>让灯预热十分钟，遮住房间的光，并锁定亮度</translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation>还没有图像</translation>
    </message>
    <message>
        <source>{} dots are found</source>
        <translation>找到 {} 个标记点</translation>
    </message>
    <message>
        <source>{} of {} dots are found</source>
        <translation>找到 {} / {} 个标记点</translation>
    </message>
    <message>
        <source>light the dots evenly, keep both rows in the picture, and check how many the finger has</source>
        <translation>均匀照亮标记点，使两行都在图像内，并核对手指有多少标记点</translation>
    </message>
    <message>
        <source>&apos;joint&apos; is several times closer, and says how sure it is</source>
        <translation>&apos;joint&apos; 精确数倍，并给出其可信程度</translation>
    </message>
    <message>
        <source>&apos;joint&apos; solves all presses together, which takes seconds</source>
        <translation>&apos;joint&apos; 同时求解全部按压，需要几秒</translation>
    </message>
    <message>
        <source>&apos;moebius&apos; and &apos;kubelka-munk&apos; need few presses where the layer is even; &apos;polynomial&apos; follows any layer, given more of them</source>
        <translation>层均匀时 &apos;moebius&apos; 和 &apos;kubelka-munk&apos; 只需少量按压；&apos;polynomial&apos; 能适应任何层，但需要更多按压</translation>
    </message>
    <message>
        <source>&apos;auto&apos; fits all of them and leaves presses out of each</source>
        <translation>&apos;auto&apos; 拟合全部类型，并逐一排除按压</translation>
    </message>
    <message numerus="yes">
        <source>{} iterations</source>
        <comment>{} iteration</comment>
        <translation>
            <numerusform>{} 次迭代</numerusform>
        </translation>
    </message>
    <message>
        <source>the finger has no reference recording, or is not calibrated yet</source>
        <translation>手指没有参考录像，或尚未标定</translation>
    </message>
    <message>
        <source>alltact reference, then alltact calibrate</source>
        <translation>先 alltact reference，再 alltact calibrate</translation>
    </message>
    <message>
        <source>no picture of the reference recording shows the face</source>
        <translation>参考录像中没有一张图像显示面</translation>
    </message>
    <message>
        <source>how time and memory grow, of {}</source>
        <translation>时间和内存如何增长：{}</translation>
    </message>
    <message>
        <source>one frame</source>
        <translation>一帧</translation>
    </message>
    <message>
        <source>pixels of the picture</source>
        <translation>图像的像素数</translation>
    </message>
    <message>
        <source>pictures of {} x {}</source>
        <translation>{} x {} 的图像</translation>
    </message>
    <message>
        <source>memory: of a reference of {} frames</source>
        <translation>内存：{} 帧的参考</translation>
    </message>
    <message>
        <source>finding the nearest pose</source>
        <translation>查找最近的姿态</translation>
    </message>
    <message>
        <source>recorded frames</source>
        <translation>已录制的帧</translation>
    </message>
    <message>
        <source>a recording of {} frames</source>
        <translation>{} 帧的录像</translation>
    </message>
    <message>
        <source>{} of {} searches found what looking at all frames finds</source>
        <translation>{} / {} 次查找得到与逐帧查找相同的结果</translation>
    </message>
    <message>
        <source>numbering dots seen anew</source>
        <translation>给新看到的标记点编号</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>标记点</translation>
    </message>
    <message numerus="yes">
        <source>{} markers</source>
        <comment>{} marker</comment>
        <translation>
            <numerusform>{} 个标记点</numerusform>
        </translation>
    </message>
    <message>
        <source>{} of {} layouts were numbered</source>
        <translation>{} / {} 个布局完成编号</translation>
    </message>
    <message>
        <source>calibrating</source>
        <translation>标定</translation>
    </message>
    <message numerus="yes">
        <source>calibrating with {} presses</source>
        <comment>calibrating with {} press</comment>
        <translation>
            <numerusform>用 {} 次按压标定</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} presses are different ones, the others their copies</source>
        <comment>{} press is a different one, the others its copies</comment>
        <translation>
            <numerusform>{} 次按压各不相同，其余为其副本</numerusform>
        </translation>
    </message>
    <message>
        <source>measuring a recording at a quarter of the pixels a side</source>
        <translation>以每边四分之一的像素测量录像</translation>
    </message>
    <message>
        <source>seconds of the recording, at 30 frames each</source>
        <translation>录像的秒数，每秒 30 帧</translation>
    </message>
    <message>
        <source>a recording of {:.0f} s</source>
        <translation>{:.0f} s 的录像</translation>
    </message>
    <message>
        <source>{} frames of the longest were measured; memory: the most that was held beside the reference</source>
        <translation>测量了最长录像的 {} 帧；内存：参考之外占用的最大值</translation>
    </message>
    <message>
        <source>its error is told from the third view on</source>
        <translation>其误差从第三个视图起给出</translation>
    </message>
    <message>
        <source>no frame shows a face</source>
        <translation>没有一帧显示面</translation>
    </message>
    <message>
        <source>the picture cannot be written</source>
        <translation>无法写入图片</translation>
    </message>
    <message>
        <source>another folder, or freeing some space</source>
        <translation>选择其他文件夹，或腾出空间</translation>
    </message>
    <message>
        <source>there is no cross-section</source>
        <translation>没有剖面</translation>
    </message>
    <message>
        <source>two points, A and B</source>
        <translation>使用两个点 A 和 B</translation>
    </message>
    <message>
        <source>the figure cannot be written</source>
        <translation>无法写入图</translation>
    </message>
    <message>
        <source>there is no room to try the recording in</source>
        <translation>没有空间试用此录像</translation>
    </message>
    <message>
        <source>freeing some space on the disk</source>
        <translation>腾出磁盘空间</translation>
    </message>
    <message>
        <source>the finger could not be copied: {}</source>
        <translation>无法复制手指：{}</translation>
    </message>
    <message>
        <source>the quick guide&apos;s texts do not fit on {} pages</source>
        <translation>快速指南的文字放不进 {} 页</translation>
    </message>
    <message>
        <source>shorten the numbered lists of the help pages</source>
        <translation>缩短帮助页中的编号列表</translation>
    </message>
    <message>
        <source>the markers tell from which side the finger is pushed, but not how far from its base: a push on a side moves them alike wherever it is</source>
        <translation>标记点能说明手指从哪一侧被推，但不能说明距根部多远：对侧面的推压无论在何处，都以同样方式移动它们</translation>
    </message>
    <message>
        <source>a change of the finger that was interrupted cannot be completed: {}</source>
        <translation>无法完成被中断的手指更改：{}</translation>
    </message>
    <message>
        <source>{} lies in a folder that is a link to elsewhere</source>
        <translation>{} 所在的文件夹是指向别处的链接</translation>
    </message>
    <message>
        <source>putting that folder itself there instead of the link</source>
        <translation>用该文件夹本身代替链接</translation>
    </message>
    <message>
        <source>this is no list of files to be changed</source>
        <translation>这不是待更改文件的列表</translation>
    </message>
    <message>
        <source>removing it; the finger&apos;s files are then some old, some new</source>
        <translation>删除它；此后手指的文件部分为旧、部分为新</translation>
    </message>
    <message>
        <source>could not be changed</source>
        <translation>无法更改</translation>
    </message>
    <message>
        <source>could not read the folder</source>
        <translation>无法读取文件夹</translation>
    </message>
    <message>
        <source>what the ways of finding markers cost and gain</source>
        <translation>各种标记查找方法的代价与收益</translation>
    </message>
    <message>
        <source>blobs, the default</source>
        <translation>斑点（默认）</translation>
    </message>
    <message>
        <source>the paper&apos;s rows</source>
        <translation>论文的行排序</translation>
    </message>
    <message>
        <source>network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>清晰</translation>
    </message>
    <message>
        <source>half hidden</source>
        <translation>半遮挡</translation>
    </message>
    <message>
        <source>worn</source>
        <translation>磨损</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>模糊</translation>
    </message>
    <message>
        <source>partly lit</source>
        <translation>部分照明</translation>
    </message>
    <message>
        <source>dirty</source>
        <translation>脏污</translation>
    </message>
    <message>
        <source>{}: markers in sight that are found</source>
        <translation>{}：可见标记中被找到的</translation>
    </message>
    <message>
        <source>{}: told as seen, and elsewhere</source>
        <translation>{}：报告为可见但位置不对</translation>
    </message>
    <message>
        <source>{}: those found, root mean square</source>
        <translation>{}：已找到的，均方根</translation>
    </message>
    <message>
        <source>{}: hidden ones, root mean square</source>
        <translation>{}：被遮挡的，均方根</translation>
    </message>
    <message>
        <source>{}: time of a frame, median</source>
        <translation>{}：每帧时间，中位数</translation>
    </message>
    <message>
        <source>what is difficult</source>
        <translation>困难所在</translation>
    </message>
    <message>
        <source>markers in sight that are found, each frame by itself</source>
        <translation>可见标记中被找到的，每帧单独处理</translation>
    </message>
    <message>
        <source>found (%)</source>
        <translation>已找到（%）</translation>
    </message>
    <message>
        <source>how far hidden markers are from where they are said to be</source>
        <translation>被遮挡标记与报告位置的距离</translation>
    </message>
    <message>
        <source>root mean square (px)</source>
        <translation>均方根（px）</translation>
    </message>
    <message>
        <source>The demonstration&apos;s finger and {} drawn at random, which the network has not been trained on. Blobs and network are numbered by the recording, the paper&apos;s rows from left to right with hidden ones between their neighbours; each frame is looked at anew, as if none had come before. The paper tells no figure of its markers</source>
        <translation>演示用手指以及 {} 个随机生成的手指，网络未用它们训练过。斑点和网络按参考录像编号，论文的行从左到右编号，被遮挡的取相邻标记之间；每帧都重新查看，不依赖前一帧。论文未给出其标记的数据</translation>
    </message>
    <message>
        <source>{} was last changed at {}, and this computer&apos;s clock says {}: set the clock</source>
        <translation>{} 上次更改于 {}，而本机时钟显示 {}：请校准时钟</translation>
    </message>
    <message>
        <source>its disk takes long to answer and is waited for</source>
        <translation>其磁盘响应缓慢，正在等待</translation>
    </message>
    <message>
        <source>wait; if it lasts, check whether another program keeps that disk busy, then its network or cable</source>
        <translation>请稍候；若持续如此，请检查是否有其他程序占用该磁盘，再检查其网络或连接线</translation>
    </message>
    <message>
        <source>the push on the back moves the markers too little, or bends the finger too far, to tell how far from the base it is</source>
        <translation>背面的按压使标记移动太少，或使手指弯曲过大，无法得知它离基部多远</translation>
    </message>
    <message>
        <source>The camera&apos;s clock was set by {:+.1f} s: until it is right again, pictures count as taken when they come</source>
        <translation>相机的时钟被调整了 {:+.1f} 秒：在它恢复正确之前，图像按到达时间计</translation>
    </message>
    <message>
        <source>The camera sent a picture twice ({}): a mean over several pictures is less sure than it says</source>
        <translation>相机把一张图像发送了两次（{}）：多张图像的平均值不如所示的那样可靠</translation>
    </message>
    <message>
        <source>There are no pages of the report: {}.</source>
        <translation>报告没有页面：{}。</translation>
    </message>
    <message>
        <source>there is not enough memory to draw</source>
        <translation>内存不足，无法绘制</translation>
    </message>
    <message>
        <source>holds a number that no calibration has</source>
        <translation>包含任何标定都不会有的数值</translation>
    </message>
    <message>
        <source>must have a row for each contradiction</source>
        <translation>每个矛盾必须有一行</translation>
    </message>
    <message>
        <source>must hold five numbers in each row</source>
        <translation>每行必须有五个数</translation>
    </message>
    <message>
        <source>unchanged since the calibration</source>
        <translation>标定后未改动</translation>
    </message>
    <message>
        <source>the reference ({}) is newer than the calibration ({}): {}</source>
        <translation>参考（{}）比标定（{}）新：{}</translation>
    </message>
    <message>
        <source>a check needs {} presses at different positions; these are at {}: press again</source>
        <translation>检查需要 {} 次不同位置的按压；现有 {} 个位置：请继续按压</translation>
    </message>
    <message>
        <source>a check needs {} presses at different positions; these are at {}: press also in these thirds: {}</source>
        <translation>检查需要 {} 次位置不同的按压，现有 {} 处：请在以下三分之一区域也按压：{}</translation>
    </message>
    <message numerus="yes">
        <source>at {0} positions</source>
        <comment>at {0} position</comment>
        <translation>
            <numerusform>{0} 处</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{1:.3f} mm of depth error on {0} presses {4} (passes up to {2:.3f} mm), light {3:+.1f} %</source>
        <comment>{1:.3f} mm of depth error on {0} press {4} (passes up to {2:.3f} mm), light {3:+.1f} %</comment>
        <translation>
            <numerusform>{0} 次按压（{4}）的深度误差为 {1} mm（不超过 {2} mm 即通过），光照 {3} %</numerusform>
        </translation>
    </message>
    <message>
        <source>left out: {}</source>
        <translation>已排除：{}</translation>
    </message>
    <message>
        <source>too few to tell</source>
        <translation>数量太少，无法判断</translation>
    </message>
    <message>
        <source>a check needs {} images, {} could be measured</source>
        <translation>检查需要 {} 幅图像，可测量的有 {} 幅</translation>
    </message>
    <message>
        <source>camera, face or markers</source>
        <translation>相机、测量面或标记点</translation>
    </message>
    <message>
        <source>{:.2f} to {:.2f} mm</source>
        <translation>{} 至 {} mm</translation>
    </message>
    <message>
        <source>{:.2f} mm</source>
        <translation>{} mm</translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses have a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</source>
        <comment>{0} of {1} presses has a dark part wider than the ball of {2:.2f} mm diameter ({3} radius): check the ball&apos;s radius</comment>
        <translation>
            <numerusform>{1} 次按压中有 {0} 次的暗区比直径 {2} mm 的球还宽（半径 {3}）：请核对球的半径</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses are deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</source>
        <comment>{0} of {1} presses is deeper than the layer of {2:.2f} mm ({3}): check the layer&apos;s thickness and the ball&apos;s radius</comment>
        <translation>
            <numerusform>{1} 次按压中有 {0} 次比 {2} mm 的层还深（{3}）：请核对层厚和球的半径</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{0} of {1} presses are darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with them</source>
        <comment>{0} of {1} presses is darker than the mapping reaches ({3} deep, the mapping ends at {2:.2f} mm): calibrate again with it</comment>
        <translation>
            <numerusform>{1} 次按压中有 {0} 次比映射范围更暗（深 {3}，映射止于 {2} mm）：请加入这些按压重新标定</numerusform>
        </translation>
    </message>
    <message>
        <source>the face is given {:.2f} mm wide, but camera and presses show {}: check the width and the lens</source>
        <translation>给定的测量面宽度为 {} mm，但相机和按压显示为 {}：请核对宽度和镜头</translation>
    </message>
    <message>
        <source>mostly the curve&apos;s shape: add presses of different depth and position</source>
        <translation>主要来自曲线形状：请增加不同深度和位置的按压</translation>
    </message>
    <message>
        <source>mostly scale: measure one press&apos;s depth</source>
        <translation>主要来自比例：请测量一次按压的深度</translation>
    </message>
    <message>
        <source>mostly noise and reference of single pixels: record the reference again, with more light</source>
        <translation>主要来自单个像素的噪声和参考：请加强照明后重新录制参考</translation>
    </message>
    <message>
        <source>mostly parts of the face far from any press: press there</source>
        <translation>主要来自远离所有按压的区域：请在那里按压</translation>
    </message>
    <message>
        <source>mostly depth read beside contacts, as light that scatters sideways gives</source>
        <translation>主要来自接触旁边的深度，侧向散射的光会造成这种现象</translation>
    </message>
    <message>
        <source>mostly the ball&apos;s radius: measure it to a hundredth of a millimetre</source>
        <translation>主要来自球的半径：请测量到百分之一毫米</translation>
    </message>
    <message>
        <source>no press in the {} third; press there once</source>
        <translation>“{}”三分之一区没有按压；请在那里按压一次</translation>
    </message>
    <message>
        <source>no press in these thirds: {}; press once in each</source>
        <translation>以下三分之一区没有按压：{}；请各按压一次</translation>
    </message>
    <message>
        <source>{} was changed since the calibration: {}</source>
        <translation>标定后改动过：{}；{}</translation>
    </message>
    <message>
        <source>{} were changed since the calibration: {}</source>
        <translation>标定后改动过：{}；{}</translation>
    </message>
    <message>
        <source>the reference is newer than the calibration: {}</source>
        <translation>参考比标定新：{}</translation>
    </message>
    <message>
        <source>there is no reference: record one</source>
        <translation>没有参考：请录制</translation>
    </message>
    <message>
        <source>a file of the reference is missing: restore it, or record the reference again</source>
        <translation>缺少参考的一个文件：请恢复它，或重新录制参考</translation>
    </message>
    <message>
        <source>the reference is cut off or unreadable: record it again</source>
        <translation>参考不完整或无法读取：请重新录制</translation>
    </message>
    <message>
        <source>the reference has another image size than the camera: record it again</source>
        <translation>参考的图像尺寸与相机不同：请重新录制</translation>
    </message>
    <message>
        <source>width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>层厚</translation>
    </message>
    <message>
        <source>distance of the face</source>
        <translation>测量面距离</translation>
    </message>
    <message>
        <source>camera or lens</source>
        <translation>相机或镜头</translation>
    </message>
    <message>
        <source>an earlier version calibrated it and stored too little: {}</source>
        <translation>由早期版本标定，保存的信息太少：{}</translation>
    </message>
    <message>
        <source>the calibration was stopped before its end: {}</source>
        <translation>标定未完成就被停止：{}</translation>
    </message>
    <message>
        <source>no press was left out to show what happens on others</source>
        <translation>没有留出按压来检验其他情况</translation>
    </message>
    <message>
        <source>one press cannot show what happens on others; add presses of different depth</source>
        <translation>一次按压无法说明其他情况；请增加不同深度的按压</translation>
    </message>
    <message>
        <source>{} of {} presses needed; add more</source>
        <translation>需要的按压：{}/{}；请增加</translation>
    </message>
    <message numerus="yes">
        <source>all presses are at {0} positions, {1} are needed; press at others</source>
        <comment>all presses are at {0} position, {1} are needed; press at others</comment>
        <translation>
            <numerusform>所有按压只在 {0} 个位置，需要 {1} 个；请在其他位置按压</numerusform>
        </translation>
    </message>
    <message>
        <source>all presses are about {:.2f} mm deep; press shallower and deeper as well</source>
        <translation>所有按压都约 {} mm 深；请也按得更浅和更深</translation>
    </message>
    <message>
        <source>the presses do not tell how certain the scale is; add presses</source>
        <translation>按压无法说明比例有多可靠；请增加按压</translation>
    </message>
    <message>
        <source>{} of {} presses had to be left out; find out why</source>
        <translation>{} / {} 次按压不得不排除；请查明原因</translation>
    </message>
    <message>
        <source>neither calibrated nor checked for {:.0f} days; check it with {} presses</source>
        <translation>{} 天未标定也未检查；请用 {} 次按压检查</translation>
    </message>
    <message>
        <source>beside contacts {:.3f} mm of depth is read: light scatters sideways there, or the skin is pressed in</source>
        <translation>接触旁边测得 {} mm 深度：光在那里侧向散射，或表层被带着下陷</translation>
    </message>
    <message>
        <source>fine relief needs an error of at most {:.2f} mm</source>
        <translation>测量精细起伏要求误差不超过 {} mm</translation>
    </message>
    <message>
        <source>ball of {:.2f} mm diameter</source>
        <translation>直径 {} mm 的球</translation>
    </message>
    <message>
        <source>balls of {:.2f} to {:.2f} mm diameter</source>
        <translation>直径 {} 至 {} mm 的球</translation>
    </message>
    <message>
        <source>layer {:.2f} mm</source>
        <translation>层厚 {} mm</translation>
    </message>
    <message>
        <source>image {:.2f} mm wide</source>
        <translation>图像宽 {} mm</translation>
    </message>
    <message>
        <source>face {:.2f} mm wide</source>
        <translation>测量面宽 {} mm</translation>
    </message>
    <message>
        <source>expected error {:.3f} mm</source>
        <translation>预期误差 {} mm</translation>
    </message>
    <message>
        <source>expected error {:.3f} mm, {}</source>
        <translation>预期误差 {} mm，{}</translation>
    </message>
    <message>
        <source>no error can be expected of it</source>
        <translation>无法给出预期误差</translation>
    </message>
    <message>
        <source>calibrate again from the stored presses</source>
        <translation>请用已保存的按压重新标定</translation>
    </message>
    <message>
        <source>mostly bodies of other shape than the ball: measure one press&apos;s depth</source>
        <translation>主要来自与球形状不同的物体：请测量一次按压的深度</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a whole number</source>
        <translation>“{}”不是整数</translation>
    </message>
</context>
</TS>
