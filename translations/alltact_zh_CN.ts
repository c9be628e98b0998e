<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Figures</name>
    <message>
        <source>Depth SD (mm)</source>
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
        <translation>沿法线</translation>
    </message>
    <message>
        <source>projected</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Mapping minus ball (mm)</source>
        <translation>映射与球之差 (mm)</translation>
    </message>
    <message>
        <source>Press error (mm)</source>
        <translation>按压误差 (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyModel</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Time per image (ms)</source>
        <translation>每张图像的时间 (ms)</translation>
    </message>
    <message>
        <source>Median depth error (mm)</source>
        <translation>深度误差中位数 (mm)</translation>
    </message>
    <message>
        <source>Depth error, 95 % within (mm)</source>
        <translation>深度误差，95 % 在内 (mm)</translation>
    </message>
    <message>
        <source>Median position error (mm)</source>
        <translation>位置误差中位数 (mm)</translation>
    </message>
    <message>
        <source>Rating</source>
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
        <source>misses some images</source>
        <translation>部分图像无法测量</translation>
    </message>
    <message>
        <source>in use now; %1</source>
        <translation>正在使用；%1</translation>
    </message>
    <message>
        <source>loss not visible in these images</source>
        <translation>其损失在这些图像中看不出</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyPage</name>
    <message>
        <source>Set the required speed and error. The program measures once, on images of this finger, what each setting costs in time and gains in accuracy. Then it shows one answer here.</source>
        <translation>请设定所需的速度和允许的误差。程序用此手指的图像测量一次各项设置所花的时间和带来的精度，然后在此给出一个答案。</translation>
    </message>
    <message>
        <source>&amp;Measure settings on this finger (about 12 s)</source>
        <translation>在此手指上测量各项设置（约 12 秒）(&amp;M)</translation>
    </message>
    <message>
        <source>Images per &amp;second</source>
        <translation>每秒图像数(&amp;S)</translation>
    </message>
    <message>
        <source>Images per second</source>
        <translation>每秒图像数</translation>
    </message>
    <message>
        <source>Maximum er&amp;ror</source>
        <translation>最大误差(&amp;R)</translation>
    </message>
    <message>
        <source>Maximum error</source>
        <translation>最大误差</translation>
    </message>
    <message>
        <source>95 % of all points have a smaller depth error.</source>
        <translation>95 % 的点深度误差小于此值。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>smallest possible</source>
        <translation>尽可能小</translation>
    </message>
    <message>
        <source>Restore as cali&amp;brated</source>
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
        <source>Results so far are saved; measuring continues from there next time.</source>
        <translation>已有结果会保存，下次从那里继续测量。</translation>
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
        <source>%1 ms per image; depth: half of all points within %2 mm, 95 % within %3 mm</source>
        <translation>每张图像 %1 ms；深度：一半的点在 %2 mm 内，95 % 在 %3 mm 内</translation>
    </message>
    <message>
        <source>In use now.</source>
        <translation>正在使用。</translation>
    </message>
    <message>
        <source>Change from now: %1</source>
        <translation>与当前不同：%1</translation>
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
        <source>%1 mm more accurate than now</source>
        <translation>误差比现在小 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm less accurate than now</source>
        <translation>误差比现在大 %1 mm</translation>
    </message>
    <message>
        <source>Open a finger first.</source>
        <translation>请先打开手指。</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>正在加载手指。</translation>
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
        <source>measuring the settings…</source>
        <translation>正在测量各项设置…</translation>
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
        <source>The most accurate setting within %1 ms.</source>
        <translation>不超过 %1 ms 的设置中最准确的一个。</translation>
    </message>
    <message>
        <source>The fastest setting with 95 % of all points within %1 mm.</source>
        <translation>使 95 % 的点误差不超过 %1 mm 的最快设置。</translation>
    </message>
    <message>
        <source>No setting reaches %1 mm. This is the most accurate within %2 ms.</source>
        <translation>没有设置能达到 %1 mm。这是不超过 %2 ms 的设置中最准确的。</translation>
    </message>
    <message>
        <source>An error of %1 mm allows %2 images per second. This is the most accurate setting that is fast enough.</source>
        <translation>误差为 %1 mm 时每秒可处理 %2 张图像。这是足够快的设置中最准确的。</translation>
    </message>
    <message>
        <source>No setting is that fast on this computer. This is the fastest: %1 images per second.</source>
        <translation>这台计算机上没有这么快的设置。最快的是这个：每秒 %1 张图像。</translation>
    </message>
    <message>
        <source>No setting can measure this finger&apos;s images.</source>
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
        <source>&amp;Measure missing settings</source>
        <translation>测量缺少的设置(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Measure setting pairs, too</source>
        <translation>也测量设置组合(&amp;M)</translation>
    </message>
    <message>
        <source>Live, side by side</source>
        <translation>实时并排</translation>
    </message>
    <message>
        <source>Figure, table or the live image with two settings</source>
        <translation>图、表格，或用两种设置的实时画面</translation>
    </message>
    <message>
        <source>These images cannot show its loss: their light is that of the recording.</source>
        <translation>这些图像看不出它的损失，因为图像的光照就是录像时的光照。</translation>
    </message>
    <message>
        <source>position: half within %1 mm</source>
        <translation>位置：一半的点在 %1 mm 内</translation>
    </message>
    <message>
        <source>Measures with the setting of the calibration again</source>
        <translation>恢复使用标定时的设置</translation>
    </message>
    <message>
        <source>Copies the command that does the same in a terminal</source>
        <translation>复制在终端执行同样操作的命令</translation>
    </message>
    <message>
        <source>Ends measuring; the settings so far are shown</source>
        <translation>停止测量；显示已测的设置</translation>
    </message>
    <message>
        <source>Computes error and time of many settings from the presses</source>
        <translation>由按压计算多种设置的误差和耗时</translation>
    </message>
    <message>
        <source>This finger is measured with the chosen setting from now on; undo takes it back</source>
        <translation>此后用所选设置测量此手指；可撤销</translation>
    </message>
    <message>
        <source>Computes error and time of further settings from the presses</source>
        <translation>由按压计算更多设置的误差和耗时</translation>
    </message>
    <message>
        <source>Only settings that keep up with it are offered</source>
        <translation>只提供跟得上此速率的设置</translation>
    </message>
</context>
<context>
    <name>alltact::AccuracyPlot</name>
    <message>
        <source>Error versus time per image</source>
        <translation>误差与每张图像的时间</translation>
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
        <source>Time per image on this computer (ms)</source>
        <translation>在这台计算机上每张图像的时间 (ms)</translation>
    </message>
    <message>
        <source>Depth error (mm)</source>
        <translation>深度误差 (mm)</translation>
    </message>
    <message>
        <source>slower or worse than another</source>
        <translation>比别的更慢或更差</translation>
    </message>
    <message numerus="yes">
        <source>%n slower or worse, outside this figure</source>
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
        <source>%1 images per second</source>
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
        <source>Error versus time per image, as a table</source>
        <translation>误差与每张图像的时间（表格）</translation>
    </message>
    <message>
        <source>Order of the rows below</source>
        <translation>下方各行的顺序</translation>
    </message>
</context>
<context>
    <name>alltact::AgeLabel</name>
    <message>
        <source>Image age</source>
        <translation>图像延迟</translation>
    </message>
    <message>
        <source>images without timestamps</source>
        <translation>图像没有时间戳</translation>
    </message>
    <message>
        <source>image %1 s old</source>
        <translation>图像延迟 %1 s</translation>
    </message>
    <message>
        <source>image %1 ms old</source>
        <translation>图像延迟 %1 ms</translation>
    </message>
    <message>
        <source>Motion appears late. Close other programs, or choose a faster setting on the Accuracy page.</source>
        <translation>运动显示有延迟。请关闭其他程序，或在“精度”页面选择更快的设置。</translation>
    </message>
</context>
<context>
    <name>alltact::BrightnessBox</name>
    <message>
        <source>Width of the edges of the face in the image: the smaller, the sharper. A sharp image has about 2 to 4 px. Turn the lens until both ends are sharp. Best: the least of the last 30 seconds.</source>
        <translation>接触面边缘在图像中的宽度：越小越清晰。清晰的图像约为 2 至 4 px。转动镜头，直到两端都清晰。最佳：最近 30 秒内的最小值。</translation>
    </message>
    <message>
        <source>Focus at the base: %1</source>
        <translation>根部对焦：%1</translation>
    </message>
    <message>
        <source>Focus at the tip: %1</source>
        <translation>指尖对焦：%1</translation>
    </message>
    <message>
        <source>%1 px (best: %2 px)</source>
        <translation>%1 px（最佳：%2 px）</translation>
    </message>
    <message>
        <source>no edges in view</source>
        <translation>图像中没有边缘</translation>
    </message>
    <message>
        <source>Pixels by grey level</source>
        <translation>按灰度值统计的像素</translation>
    </message>
    <message>
        <source>Pixels by grey level, dark at the left. Bars in another colour at the ends are too dark or too bright to measure.</source>
        <translation>按灰度值统计的像素，左侧为暗。两端以其他颜色显示的部分过暗或过亮，无法测量。</translation>
    </message>
    <message>
        <source>No image yet.</source>
        <translation>还没有图像。</translation>
    </message>
    <message>
        <source>&lt; %1 %</source>
        <translation>&lt; %1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Face: %1 too bright, %2 too dark</source>
        <translation>接触面：%1 过亮，%2 过暗</translation>
    </message>
    <message>
        <source>Image: %1 too bright, %2 too dark</source>
        <translation>图像：%1 过亮，%2 过暗</translation>
    </message>
</context>
<context>
    <name>alltact::CalibratePage</name>
    <message>
        <source>&amp;Next: %1</source>
        <translation>下一步：%1(&amp;N)</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>标定(&amp;C)</translation>
    </message>
    <message>
        <source>Opens the next step</source>
        <translation>打开下一步</translation>
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
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>O&amp;perator</source>
        <translation>操作者(&amp;P)</translation>
    </message>
    <message>
        <source>Stored with the check: it separates operators from repetitions in a gage study.</source>
        <translation>随检查保存：在量具研究中区分操作者与重复测量。</translation>
    </message>
    <message>
        <source>Three presses</source>
        <translation>三次按压</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Press the calibration ball at three positions, base, middle and tip, and take an image of each. The calibration does not change.</source>
        <translation>用标定时的球在根部、中部和指尖三个位置按压，各拍一张图像。标定保持不变。</translation>
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
        <source>There is no live image: choose a source.</source>
        <translation>没有实时画面：请选择来源。</translation>
    </message>
    <message>
        <source>The finger is not calibrated.</source>
        <translation>手指尚未标定。</translation>
    </message>
    <message>
        <source>The check is running.</source>
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
        <source>The last check, on %1, tested an earlier calibration.</source>
        <translation>上次检查（%1）针对的是更早的标定。</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es) taken: enough.</source>
        <translation>
            <numerusform>已拍摄 %n 次按压：足够了。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Last checked on %1 with %n press(es): error %2 mm (limit %3 mm).</source>
        <translation>
            <numerusform>上次检查：%1，%n 次按压，误差 %2 mm（限值 %3 mm）。</numerusform>
        </translation>
    </message>
    <message>
        <source>A check needs %1 presses at different positions: press again.</source>
        <translation>检查需要 %1 次位置不同的按压：请再次按压。</translation>
    </message>
    <message>
        <source>Stores the present image as a press of the ball</source>
        <translation>把当前图像存为一次球的按压</translation>
    </message>
    <message>
        <source>Discards the presses of this check</source>
        <translation>放弃本次检查的按压</translation>
    </message>
    <message>
        <source>Compares the measured depth with the ball, and adds the result to the history</source>
        <translation>把测得的深度与球比较，并把结果记入历史</translation>
    </message>
    <message>
        <source>Your name or initials, stored with the check</source>
        <translation>您的姓名或缩写，随检查一起保存</translation>
    </message>
</context>
<context>
    <name>alltact::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>查找命令</translation>
    </message>
    <message>
        <source>Words of the command</source>
        <translation>命令中的文字</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Menu or page</source>
        <translation>菜单或页面</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>this page</source>
        <translation>本页</translation>
    </message>
    <message>
        <source>Any words of the command, in any order; Enter runs the marked one</source>
        <translation>命令中的任意词，顺序不限；Enter 执行所选命令</translation>
    </message>
</context>
<context>
    <name>alltact::ContactWords</name>
    <message>
        <source>Contact on the contact face</source>
        <translation>接触面有接触</translation>
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
        <source>(normal to the face)</source>
        <translation>（接触面法线）</translation>
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
            <numerusform>接触面上有 %n 处接触。</numerusform>
        </translation>
    </message>
    <message>
        <source>It slips or rolls over the skin.</source>
        <translation>它在表皮上打滑或滚动。</translation>
    </message>
    <message>
        <source>Unknown without a reference recording.</source>
        <translation>没有参考录像，无法判断。</translation>
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
        <source>Along: over the face from its base. Across: from its centre line towards +y. Direction: displacement of the finger in the camera&apos;s frame; its standard deviation applies within the finger&apos;s cross-section.</source>
        <translation>纵向：沿接触面从根部算起。横向：从接触面的中线向 +y 方向。方向：手指的位移方向，以相机坐标系表示；其标准差是手指横截面内的标准差。</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>正在加载手指。</translation>
    </message>
    <message>
        <source>Open a finger to see its forces.</source>
        <translation>请打开一个手指以查看其受力。</translation>
    </message>
    <message>
        <source>Forces need a finger with markers.</source>
        <translation>测力需要带标记点的手指。</translation>
    </message>
    <message>
        <source>Forces need a reference recording: record one.</source>
        <translation>测力需要参考录像：请录制。</translation>
    </message>
    <message>
        <source>No force is estimated for this image.</source>
        <translation>此图像没有力的估计值。</translation>
    </message>
    <message>
        <source>This finger has no force model yet. Train one with a table of its markers and a gauge&apos;s forces:</source>
        <translation>此手指还没有力模型。请用包含其标记点和测力计读数的表训练一个：</translation>
    </message>
    <message>
        <source>Pushed from the contact face</source>
        <translation>从接触面一侧被推</translation>
    </message>
</context>
<context>
    <name>alltact::ContrastPlot</name>
    <message>
        <source>Contrast of fine relief</source>
        <translation>细小起伏的对比度</translation>
    </message>
    <message>
        <source>The resolution is not known</source>
        <translation>分辨率未知</translation>
    </message>
    <message>
        <source>Waves per mm of the face</source>
        <translation>每毫米接触面的波数</translation>
    </message>
    <message>
        <source>Contrast of depth</source>
        <translation>深度对比度</translation>
    </message>
    <message>
        <source>half as deep as the skin</source>
        <translation>为皮肤深度的一半</translation>
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
        <source>An automatic mode controls it.</source>
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
        <source>Automatic modes stay off; unrequested changes are undone.</source>
        <translation>自动模式保持关闭，自行变化的设置会被恢复。</translation>
    </message>
    <message>
        <source>Brightness is what is measured: when locked, it does not change. Unlock it only before calibrating.</source>
        <translation>测量的就是亮度：锁定后亮度不会改变。请仅在标定之前解锁。</translation>
    </message>
    <message>
        <source>A camera&apos;s exposure, gain, white balance and focus appear here. This source is not a camera.</source>
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
    <message>
        <source>Exposure, gain, white balance and focus stay as they are; depth rests on them</source>
        <translation>曝光、增益、白平衡和对焦保持不变；深度以此为依据</translation>
    </message>
</context>
<context>
    <name>alltact::ConvergencePlot</name>
    <message>
        <source>Convergence of the solution</source>
        <translation>解的收敛过程</translation>
    </message>
    <message numerus="yes">
        <source>Residual after %n round(s): %1 mm.</source>
        <translation>
            <numerusform>%n 轮后残差为 %1 mm。</numerusform>
        </translation>
    </message>
    <message>
        <source>Convergence has not started yet</source>
        <translation>解尚未开始收敛</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Residual (mm)</source>
        <translation>残差 (mm)</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Change of the unknowns (mm)</source>
        <translation>未知量的变化 (mm)</translation>
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
        <source>No pose seen yet.</source>
        <translation>还没有看到任何姿态。</translation>
    </message>
    <message>
        <source>Enough: all directions reached.</source>
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
        <translation>最深 %1 mm，第 %2 帧</translation>
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
        <translation>深度随时间的变化需要先标定手指。</translation>
    </message>
    <message>
        <source>The recording is being analysed.</source>
        <translation>正在分析录像。</translation>
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
        <source>Data of finger %1, for other programs.</source>
        <translation>手指 %1 的数据，供其他程序使用。</translation>
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
        <translation>OpenCV：camera.opencv.yaml(&amp;O)</translation>
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
        <source>The camera in the format of drivers and image_pipeline; face, markers and mapping as parameters of a ROS 2 node.</source>
        <translation>相机采用驱动程序和 image_pipeline 可读的格式；接触面、标记点和映射作为 ROS 2 节点的参数。</translation>
    </message>
    <message>
        <source>&amp;JSON: calibration.json</source>
        <translation>JSON：calibration.json(&amp;J)</translation>
    </message>
    <message>
        <source>All values in one file, for your own programs.</source>
        <translation>全部数值放在一个文件中，供自己的程序使用。</translation>
    </message>
    <message>
        <source>E&amp;ntire finger: finger.zip</source>
        <translation>整个手指：finger.zip(&amp;N)</translation>
    </message>
    <message>
        <source>All files of the finger, with its untouched images: to archive, to send, and to measure with in Python.</source>
        <translation>手指的所有文件，包括未触碰的图像：用于保存、发送，以及在 Python 中测量。</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>没有选择任何内容。</translation>
    </message>
    <message>
        <source>No folder is chosen.</source>
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
            <numerusform>此手指未使用的 %n 段录像不包含在 zip 中。</numerusform>
        </translation>
    </message>
    <message>
        <source>Chooses the folder to write to</source>
        <translation>选择写入的文件夹</translation>
    </message>
    <message>
        <source>Copies the command that does the same in a terminal</source>
        <translation>复制在终端执行同样操作的命令</translation>
    </message>
    <message>
        <source>Writes the ticked files</source>
        <translation>写入勾选的文件</translation>
    </message>
    <message>
        <source>Ends the export; no unfinished file is left</source>
        <translation>停止导出；不留下未完成的文件</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
    </message>
</context>
<context>
    <name>alltact::FaceMapPlot</name>
    <message>
        <source>%1 over the face</source>
        <translation>接触面上的%1</translation>
    </message>
    <message>
        <source>No data for the face yet</source>
        <translation>接触面尚无数据</translation>
    </message>
    <message>
        <source>Along the finger, from the base (mm)</source>
        <translation>沿手指，从根部 (mm)</translation>
    </message>
    <message>
        <source>Along the image, from the left (mm)</source>
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
    <name>alltact::FileFilter</name>
    <message>
        <source>Videos (%1)</source>
        <translation>视频 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</source>
        <translation>图像 (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)</translation>
    </message>
</context>
<context>
    <name>alltact::FingerCards</name>
    <message>
        <source>Not calibrated yet</source>
        <translation>尚未标定</translation>
    </message>
    <message>
        <source>Calibrated; quality not stored</source>
        <translation>已标定；未保存质量</translation>
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
        <source>Drifting: see the last check</source>
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
        <source>checked %1, error %2</source>
        <translation>检查于 %1，误差 %2</translation>
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
    <message>
        <source>Due: its untouched image</source>
        <translation>待办：未触碰的图像</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Show in folder</source>
        <translation>在文件夹中显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Remove from this list</source>
        <translation>从此列表中移除(&amp;R)</translation>
    </message>
</context>
<context>
    <name>alltact::FingerListDialog</name>
    <message>
        <source>&amp;Gage R&amp;&amp;R…</source>
        <translation>量具 R&amp;&amp;R(&amp;G)…</translation>
    </message>
    <message>
        <source>Compares the checks of the selected fingers by their operators</source>
        <translation>按操作者比较所选手指的检查</translation>
    </message>
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
        <source>Quality</source>
        <translation>质量</translation>
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
        <source>&amp;Look in another folder…</source>
        <translation>在其他文件夹中查找(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Reading the fingers&apos; folders…</source>
        <translation>正在读取手指的文件夹…</translation>
    </message>
    <message numerus="yes">
        <source>%n finger(s), </source>
        <translation>
            <numerusform>%n 个手指，</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with something due</source>
        <translation>
            <numerusform>%n 个有待办事项</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with fingers</source>
        <translation>存放手指的文件夹</translation>
    </message>
    <message>
        <source>Opens the selected finger (Enter)</source>
        <translation>打开所选手指 (Enter)</translation>
    </message>
    <message>
        <source>Adds the fingers of another folder to the list</source>
        <translation>把另一文件夹中的手指加入列表</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
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
        <source>A flat, rigid sensor with a layer of %1 mm, %2 mm from the camera.</source>
        <translation>平面刚性传感器：层厚 %1 mm，距相机 %2 mm。</translation>
    </message>
    <message>
        <source>A Fin Ray finger whose face is %1 mm wide, with a layer of %2 mm and %3 dots on each side.</source>
        <translation>Fin Ray 手指：接触面宽 %1 mm，层厚 %2 mm，每侧 %3 个标记点。</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何尺寸</translation>
    </message>
    <message>
        <source>Untouched finger</source>
        <translation>未触碰的手指</translation>
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
        <source>Take the &amp;untouched image now</source>
        <translation>立即拍摄未触碰的图像(&amp;U)</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>正在加载手指。</translation>
    </message>
    <message>
        <source>The finger needs a folder of its own: make one, or open one.</source>
        <translation>手指需要自己的文件夹：请新建或打开一个。</translation>
    </message>
    <message>
        <source>The untouched image is missing: take it.</source>
        <translation>缺少未触碰的图像：请拍摄。</translation>
    </message>
    <message>
        <source>The reference recording is missing: record the finger bending, untouched.</source>
        <translation>缺少参考录像：请录制它未被触碰时的弯曲过程。</translation>
    </message>
    <message>
        <source>Measure width and layer with a caliper, and count the dots. One folder holds all data of one finger.</source>
        <translation>请用卡尺测量宽度和层厚，并数出标记点。一个手指的全部数据都保存在一个文件夹里。</translation>
    </message>
    <message>
        <source>The untouched image is available.</source>
        <translation>已有未触碰的图像。</translation>
    </message>
    <message>
        <source>The reference recording is installed.</source>
        <translation>参考录像已设置。</translation>
    </message>
    <message>
        <source>Every press is compared with one image of the untouched face.</source>
        <translation>每次按压都与一张未触碰接触面的图像比较。</translation>
    </message>
    <message>
        <source>Every press is compared with an image of the finger in the same bend, untouched. Record the finger bending in all directions, then install the recording.</source>
        <translation>每次按压都与弯曲相同、未被触碰的手指图像比较。请录制手指向各个方向弯曲的过程，然后设为参考。</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>手指</translation>
    </message>
    <message>
        <source>&amp;Width of the face</source>
        <translation>接触面宽度(&amp;W)</translation>
    </message>
    <message>
        <source>Width of the face</source>
        <translation>接触面宽度</translation>
    </message>
    <message>
        <source>&amp;Layer thickness</source>
        <translation>层厚(&amp;L)</translation>
    </message>
    <message>
        <source>Layer thickness</source>
        <translation>层厚</translation>
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
        <source>A calibrated finger then needs a new calibration.</source>
        <translation>已标定的手指之后需要重新标定。</translation>
    </message>
    <message>
        <source>change the finger&apos;s sizes</source>
        <translation>更改手指的尺寸</translation>
    </message>
    <message>
        <source>Untouched image from a &amp;file…</source>
        <translation>从文件打开未触碰的图像(&amp;F)…</translation>
    </message>
    <message>
        <source>Untouched image</source>
        <translation>未触碰的图像</translation>
    </message>
    <message>
        <source>Stores this finger on disk, so that it can be calibrated</source>
        <translation>把此手指存盘，以便标定</translation>
    </message>
    <message>
        <source>Chooses the folder of a finger that exists</source>
        <translation>选择已有手指的文件夹</translation>
    </message>
    <message>
        <source>There the reference of the untouched finger is recorded</source>
        <translation>在那里录制未触碰手指的参考</translation>
    </message>
    <message>
        <source>The present image becomes the reference; nothing may touch the face</source>
        <translation>当前图像成为参考；不能有任何东西接触表面</translation>
    </message>
    <message>
        <source>A stored image of the untouched face becomes the reference</source>
        <translation>用已存的未触碰图像作为参考</translation>
    </message>
    <message>
        <source>From edge to edge, by caliper</source>
        <translation>两边缘之间的宽度，用卡尺测量</translation>
    </message>
    <message>
        <source>Of the translucent layer; no depth is larger</source>
        <translation>半透明层的厚度；深度不会超过它</translation>
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
        <source>Summary of this finger</source>
        <translation>此手指的概况</translation>
    </message>
    <message>
        <source>Go to Record</source>
        <translation>前往“录制”</translation>
    </message>
    <message>
        <source>Go to the check</source>
        <translation>前往“检查”</translation>
    </message>
    <message>
        <source>Go to Calibrate</source>
        <translation>前往“标定”</translation>
    </message>
    <message>
        <source>Opens the page of what is due for this finger</source>
        <translation>打开此手指待办事项的页面</translation>
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
        <source>Forces use the model&apos;s own zero again.</source>
        <translation>力重新以模型自身的零点为准。</translation>
    </message>
    <message>
        <source>Force now</source>
        <translation>当前的力</translation>
    </message>
    <message>
        <source>Zero of the forces</source>
        <translation>力的零点</translation>
    </message>
    <message>
        <source>Force over the last half minute</source>
        <translation>最近半分钟的力</translation>
    </message>
    <message>
        <source>The force model was not trained on images like this one.</source>
        <translation>力模型未用与此类似的图像训练过。</translation>
    </message>
    <message>
        <source>A recording is shown as it was measured.</source>
        <translation>录像按实测值显示。</translation>
    </message>
    <message>
        <source>From now on, the mean of the last half second is the zero.</source>
        <translation>从现在起，以最近半秒的平均值为零点。</translation>
    </message>
    <message>
        <source>No reading in range can serve as zero.</source>
        <translation>没有可用作零点的有效范围内读数。</translation>
    </message>
    <message>
        <source>No force is estimated for this image.</source>
        <translation>此图像没有力的估计值。</translation>
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
        <source>Zero: the reading of %1, with the finger in contact.</source>
        <translation>零点：%1 的读数，当时手指有接触。</translation>
    </message>
    <message>
        <source>Zero: the reading of %1.</source>
        <translation>零点：%1 的读数。</translation>
    </message>
    <message>
        <source>re-zero the force</source>
        <translation>力重新归零</translation>
    </message>
    <message>
        <source>show the force as measured</source>
        <translation>按测量值显示力</translation>
    </message>
    <message>
        <source>Train the forces…</source>
        <translation>训练力模型…</translation>
    </message>
    <message>
        <source>Makes a force model from a table of markers and a gauge&apos;s forces</source>
        <translation>用标记点和测力计读数的表建立力模型</translation>
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
    <name>alltact::FrameStrip</name>
    <message>
        <source>Frames of the recording</source>
        <translation>录像的帧</translation>
    </message>
    <message>
        <source>used</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>same pose as others</source>
        <translation>姿态与其他帧相同</translation>
    </message>
    <message>
        <source>contact, certain or possible</source>
        <translation>接触（确定或可能）</translation>
    </message>
    <message>
        <source>left out by you</source>
        <translation>由您舍弃</translation>
    </message>
    <message>
        <source>no face or markers</source>
        <translation>没有接触面或标记点</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Frame %1: %2</source>
        <translation>第 %1 帧：%2</translation>
    </message>
    <message>
        <source>Frame %1, the rest pose: %2</source>
        <translation>第 %1 帧，静止姿态：%2</translation>
    </message>
    <message>
        <source>represented by neighbouring frames</source>
        <translation>由相邻帧代表</translation>
    </message>
</context>
<context>
    <name>alltact::GageDialog</name>
    <message>
        <source>Table of readings</source>
        <translation>读数表</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv)</source>
        <translation>表格 (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>Gage R&amp;R</source>
        <translation>量具 R&amp;R</translation>
    </message>
    <message>
        <source>How much of the variation of measured depths comes from measuring: from operators, and from repetitions. A reading is the mean depth error of one check; each operator checks each finger two times or more.</source>
        <translation>测得深度的变差有多少来自测量本身：来自操作者和重复测量。一个读数是一次检查的平均深度偏差；每位操作者对每个手指检查两次或更多。</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>公差(&amp;T)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Width of the tolerance that is measured with the fingers</source>
        <translation>用手指测量的公差带宽度</translation>
    </message>
    <message>
        <source>Variation by source</source>
        <translation>按来源的变差</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>方差分析</translation>
    </message>
    <message>
        <source>&amp;From a table…</source>
        <translation>从表格读取(&amp;F)…</translation>
    </message>
    <message>
        <source>With the columns part, operator and value_mm</source>
        <translation>含 part、operator 和 value_mm 列</translation>
    </message>
    <message>
        <source>C&amp;opy</source>
        <translation>复制(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Reading the checks…</source>
        <translation>正在读取检查…</translation>
    </message>
    <message>
        <source>No result.</source>
        <translation>没有结果。</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>变差</translation>
    </message>
    <message>
        <source>SD, mm</source>
        <translation>标准差 (mm)</translation>
    </message>
    <message>
        <source>95 %, mm</source>
        <translation>95 % (mm)</translation>
    </message>
    <message>
        <source>% of total</source>
        <translation>占总变差 %</translation>
    </message>
    <message>
        <source>% of tolerance</source>
        <translation>占公差 %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>重复性</translation>
    </message>
    <message>
        <source>Reproducibility</source>
        <translation>再现性</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Parts × operators</source>
        <translation>零件 × 操作者</translation>
    </message>
    <message>
        <source>Parts × operators (pooled)</source>
        <translation>零件 × 操作者（已合并）</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>总计</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>df</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>SS</source>
        <translation>SS</translation>
    </message>
    <message>
        <source>MS</source>
        <translation>MS</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n 个零件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n operator(s)</source>
        <translation>
            <numerusform>%n 位操作者</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeat(s)</source>
        <translation>
            <numerusform>重复 %n 次</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n distinct categorie(s)</source>
        <translation>
            <numerusform>可区分类别 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Copies both tables for a spreadsheet</source>
        <translation>复制两个表，供电子表格使用</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
    </message>
</context>
<context>
    <name>alltact::GripperDialog</name>
    <message>
        <source>%1 in the gripper</source>
        <translation>夹爪中的 %1</translation>
    </message>
    <message>
        <source>Pose of the camera of %1 in the gripper&apos;s frame: its position and its rotation about the gripper&apos;s axes, first x, then y, then z. A camera without rotation looks along the gripper&apos;s z; x runs along its image, y across it.</source>
        <translation>%1 的相机在夹爪坐标系中的位姿：其位置，以及绕夹爪各轴的转角，依次为 x、y、z。未转动的相机沿夹爪的 z 方向观察，x 沿图像长度方向，y 沿图像宽度方向。</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>位置(&amp;P)</translation>
    </message>
    <message>
        <source>Ro&amp;tation about</source>
        <translation>转角(&amp;T)</translation>
    </message>
    <message>
        <source>Position, x</source>
        <translation>位置，x</translation>
    </message>
    <message>
        <source>Position, y</source>
        <translation>位置，y</translation>
    </message>
    <message>
        <source>Position, z</source>
        <translation>位置，z</translation>
    </message>
    <message>
        <source>Rotation about x</source>
        <translation>绕 x 的转角</translation>
    </message>
    <message>
        <source>Rotation about y</source>
        <translation>绕 y 的转角</translation>
    </message>
    <message>
        <source>Rotation about z</source>
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
        <source>Removes the pose from the finger&apos;s file.</source>
        <translation>从手指文件中删除该位姿。</translation>
    </message>
    <message>
        <source>Both fingers are shown in the gripper&apos;s frame</source>
        <translation>两个手指都在夹爪坐标系中显示</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>关闭此窗口，不作更改（Esc）</translation>
    </message>
    <message>
        <source>Of the camera, in the gripper&apos;s frame</source>
        <translation>相机在夹爪坐标系中的位置</translation>
    </message>
    <message>
        <source>Of the camera, about the gripper&apos;s axis; x first, then y, then z</source>
        <translation>相机绕夹爪轴的转角；先 x，再 y，后 z</translation>
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
        <source>now %1 mm, %2 mm from the target</source>
        <translation>现在 %1 mm，距目标 %2 mm</translation>
    </message>
    <message>
        <source>The press is taken once ball and finger are held still.</source>
        <translation>球和手指保持不动后，即拍摄此次按压。</translation>
    </message>
    <message>
        <source>Not taken: hold ball and finger still for half a second.</source>
        <translation>未拍摄：请将球和手指保持静止半秒。</translation>
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
    <message>
        <source>Opens a camera, a recording or the simulated finger</source>
        <translation>打开相机、录像或模拟手指</translation>
    </message>
</context>
<context>
    <name>alltact::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Help on this page</source>
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

Its own source is under the BSD-3-Clause licence; with the libraries it uses, the entire program is under the GPL, version 3.</source>
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
        <source>PDF files (*.pdf)</source>
        <translation>PDF 文件 (*.pdf)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>按键(&amp;K)</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
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
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
    </message>
</context>
<context>
    <name>alltact::HistogramPlot</name>
    <message>
        <source>Distribution of errors</source>
        <translation>误差分布</translation>
    </message>
    <message>
        <source>95 % of the errors are below %1 mm.</source>
        <translation>95 % 的误差小于 %1 mm。</translation>
    </message>
    <message>
        <source>No errors to show yet</source>
        <translation>尚无可显示的误差</translation>
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
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>The camera&apos;s image. The wheel or + and - zoom, 0 shows all of it, 1 its original size. Drag or use the arrow keys to move it; Shift and the arrow keys move the probe.</source>
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
        <source>The frame is being measured again for the comparison.</source>
        <translation>正在再次测量此帧，以便比较。</translation>
    </message>
    <message>
        <source>at the layer&apos;s limit</source>
        <translation>达到层的极限</translation>
    </message>
    <message>
        <source>beyond the calibrated range</source>
        <translation>超出标定范围</translation>
    </message>
    <message>
        <source>doubtful light</source>
        <translation>光照可疑</translation>
    </message>
    <message>
        <source>steep: position matters</source>
        <translation>陡坡：受位置影响大</translation>
    </message>
    <message>
        <source>Distance, mm</source>
        <translation>距离，mm</translation>
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
        <source>set point B</source>
        <translation>设置 B 点</translation>
    </message>
    <message>
        <source>set point A</source>
        <translation>设置 A 点</translation>
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
        <source>The finger is not calibrated yet, so brightness gives no depth.</source>
        <translation>手指尚未标定，无法由亮度得到深度。</translation>
    </message>
    <message>
        <source>The face was not found in this image.</source>
        <translation>在此图像中未找到接触面。</translation>
    </message>
    <message>
        <source>The finger is being loaded.</source>
        <translation>正在加载手指。</translation>
    </message>
    <message>
        <source>Nothing can be shown; the reason is above.</source>
        <translation>无法显示；原因见上方。</translation>
    </message>
    <message>
        <source>The recording is being opened.</source>
        <translation>正在打开录像。</translation>
    </message>
    <message>
        <source>No source is open. Choose one above, or open a recording.</source>
        <translation>没有打开的来源。请在上方选择，或打开一段录像。</translation>
    </message>
    <message>
        <source>No finger is open. Open the visible finger above.</source>
        <translation>没有打开的手指。请在上方打开画面中的手指。</translation>
    </message>
    <message>
        <source>Waiting for the first image.</source>
        <translation>正在等待第一张图像。</translation>
    </message>
    <message>
        <source>Open a video</source>
        <translation>打开视频</translation>
    </message>
    <message>
        <source>Open a folder of images</source>
        <translation>打开图像文件夹</translation>
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
        <source>continue the last inspection</source>
        <translation>继续上次检视</translation>
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
        <source>pose of %1 in the gripper</source>
        <translation>设置 %1 在夹爪中的位姿</translation>
    </message>
    <message>
        <source>The camera pose of %1 in the gripper is not known, so each finger is shown in its own camera&apos;s frame.</source>
        <translation>%1 的相机在夹爪中的位姿未知，因此每个手指都显示在各自相机的坐标系中。</translation>
    </message>
    <message>
        <source>Enter its position and rotation.</source>
        <translation>请输入其位置和转角。</translation>
    </message>
    <message>
        <source>Pose of &amp;2…</source>
        <translation>&amp;2 的位姿…</translation>
    </message>
    <message>
        <source>Pose of &amp;1…</source>
        <translation>&amp;1 的位姿…</translation>
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
        <source>Vide&amp;o…</source>
        <translation>视频(&amp;O)…</translation>
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
        <source>Shown minus: %1</source>
        <translation>当前显示减去：%1</translation>
    </message>
    <message>
        <source>Not calibrated yet: the shape of the entire finger, without depth</source>
        <translation>尚未标定：显示整个手指的形状，没有深度</translation>
    </message>
    <message>
        <source>Point at the face to see its values here.</source>
        <translation>把指针移到接触面上，这里会显示该处的数值。</translation>
    </message>
    <message>
        <source>The recording was opened with the finger in %1. It is measured with the finger in %2 now.</source>
        <translation>该录像是用 %1 中的手指打开的，现在用 %2 中的手指测量。</translation>
    </message>
    <message>
        <source>&amp;Close the recording</source>
        <translation>关闭录像(&amp;C)</translation>
    </message>
    <message>
        <source>%1, %2 mm rms off</source>
        <translation>%1，偏差 %2 mm（均方根）</translation>
    </message>
    <message>
        <source>Shows the open source instead of a recording</source>
        <translation>显示打开的来源而不是录像</translation>
    </message>
    <message>
        <source>Inspects a recorded video of this finger</source>
        <translation>检视此手指的录制视频</translation>
    </message>
    <message>
        <source>Inspects a folder of images of this finger</source>
        <translation>检视此手指的图像文件夹</translation>
    </message>
    <message>
        <source>Distance of the skin from: %1</source>
        <translation>皮肤到以下物体的距离：%1</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>录像文件夹</translation>
    </message>
    <message>
        <source>Lists the recordings in this finger&apos;s folder</source>
        <translation>列出此手指文件夹中的录像</translation>
    </message>
    <message>
        <source>compare with the body %1</source>
        <translation>与物体 %1 比较</translation>
    </message>
    <message>
        <source>&amp;Images…</source>
        <translation>图像(&amp;I)…</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>录像…</translation>
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
    <name>alltact::InspectionResults</name>
    <message>
        <source>Fail: readings are outside of their tolerance.</source>
        <translation>不合格：有读数超出公差。</translation>
    </message>
    <message>
        <source>Undecided: readings are closer to a limit than their uncertainty allows to decide.</source>
        <translation>无法判定：有读数离界限太近，其不确定度不足以判定。</translation>
    </message>
    <message>
        <source>Undecided: some frames could not be read.</source>
        <translation>无法判定：部分帧无法测量。</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>%1/frame</source>
        <translation>%1/帧</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>检测</translation>
    </message>
    <message>
        <source>Readings of all frames</source>
        <translation>所有帧的测量项</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>测量项</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>离散</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>无法判定</translation>
    </message>
    <message>
        <source>Progress of the inspection</source>
        <translation>检测进度</translation>
    </message>
    <message>
        <source>The selected reading over the frames</source>
        <translation>所选测量项随帧的变化</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;table (CSV)…</source>
        <translation>保存表格 (CSV)(&amp;T)…</translation>
    </message>
    <message>
        <source>Save &amp;report (PDF)…</source>
        <translation>保存报告 (PDF)(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>The frames are being measured…</source>
        <translation>正在测量各帧…</translation>
    </message>
    <message>
        <source>Nothing was inspected.</source>
        <translation>没有检测结果。</translation>
    </message>
    <message>
        <source>Save the inspection</source>
        <translation>保存检测结果</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>已写入：%1。</translation>
    </message>
    <message numerus="yes">
        <source>Pass: all readings of %n frame(s) are within their tolerances with 95 % certainty each.</source>
        <translation>
            <numerusform>合格：%n 帧的所有读数各以 95 % 的置信度在公差内。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), no tolerances.</source>
        <translation>
            <numerusform>%n 帧，无公差。</numerusform>
        </translation>
    </message>
    <message>
        <source>Ends the inspection without a result</source>
        <translation>结束检视，没有结果</translation>
    </message>
    <message>
        <source>The table that alltact inspect writes, to the byte</source>
        <translation>与 alltact inspect 写出的表完全相同</translation>
    </message>
    <message>
        <source>A PDF to sign, in English</source>
        <translation>可供签字的英文 PDF</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
    </message>
    <message>
        <source>Readin&amp;gs</source>
        <translation>测量项(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>帧(&amp;F)</translation>
    </message>
    <message>
        <source>Results of the inspection</source>
        <translation>检测结果</translation>
    </message>
    <message>
        <source>Readings of each frame</source>
        <translation>每帧的测量项</translation>
    </message>
    <message>
        <source>A frame that is selected here is shown on the page Inspect.</source>
        <translation>在此选中的帧会显示在“检测”页面上。</translation>
    </message>
    <message>
        <source>C&amp;opy frames</source>
        <translation>复制各帧(&amp;O)</translation>
    </message>
    <message>
        <source>Copies the selected frames, or all, for a spreadsheet.</source>
        <translation>复制选中的帧或所有帧，用于电子表格。</translation>
    </message>
</context>
<context>
    <name>alltact::LocalText</name>
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
        <source>Search</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Search for dimmers</source>
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
        <source>Custom report</source>
        <translation>自定义报告</translation>
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
        <source>Set to %1 %. Every image records it.</source>
        <translation>已设为 %1 %。每张图像都会记录此值。</translation>
    </message>
    <message>
        <source>The dimmer is being set.</source>
        <translation>正在设置调光器。</translation>
    </message>
    <message>
        <source>Choose the device that dims the finger&apos;s lamp, if there is one.</source>
        <translation>如有给手指的灯调光的设备，请选择它。</translation>
    </message>
    <message>
        <source>USB device that dims the lamp; none leaves the lamp alone</source>
        <translation>调节灯光的 USB 设备；不选则不控制灯</translation>
    </message>
    <message>
        <source>Lists the dimmers that are plugged in now</source>
        <translation>列出当前插入的调光器</translation>
    </message>
    <message>
        <source>The pin or report that the lamp is connected to</source>
        <translation>灯所接的引脚或报告</translation>
    </message>
    <message>
        <source>Number, bytes and range of the HID report that sets the brightness</source>
        <translation>设置亮度的 HID 报告的编号、字节和范围</translation>
    </message>
    <message>
        <source>In per cent; every recorded image stores it</source>
        <translation>百分比；每张录制的图像都会保存它</translation>
    </message>
</context>
<context>
    <name>alltact::LensForm</name>
    <message>
        <source>Ga&amp;p / side of tags</source>
        <translation>标签间隙 / 边长(&amp;P)</translation>
    </message>
    <message>
        <source>Gap of two tags as a fraction of their side</source>
        <translation>两标签间隙占边长的比例</translation>
    </message>
    <message>
        <source>The spacing printed on the board, such as 0.3</source>
        <translation>标定板上印的间距（spacing），如 0.3</translation>
    </message>
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
        <source>standard (Brown)</source>
        <translation>标准 (Brown)</translation>
    </message>
    <message>
        <source>fisheye</source>
        <translation>鱼眼</translation>
    </message>
    <message>
        <source>Finger distance</source>
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
        <source>Tick this if the finger is seen through a plate into silicone, but the board was in air</source>
        <translation>如果相机透过平板看硅胶中的手指，而标定板是在空气中看的，请勾选</translation>
    </message>
    <message>
        <source>Air gap</source>
        <translation>空气间隙</translation>
    </message>
    <message>
        <source>Air between lens and window</source>
        <translation>镜头与窗口之间的空气</translation>
    </message>
    <message>
        <source>Window thickness</source>
        <translation>窗口厚度</translation>
    </message>
    <message>
        <source>Thickness of the window</source>
        <translation>窗口的厚度</translation>
    </message>
    <message>
        <source>Window index</source>
        <translation>窗口折射率</translation>
    </message>
    <message>
        <source>Refractive index of the window</source>
        <translation>窗口的折射率</translation>
    </message>
    <message>
        <source>Index behind it</source>
        <translation>窗口后折射率</translation>
    </message>
    <message>
        <source>Refractive index behind the window</source>
        <translation>窗口后面的折射率</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Inner corners, dots or tags</source>
        <translation>内角点、圆点或标签(&amp;I)</translation>
    </message>
    <message>
        <source>Asymmetric grid of dots</source>
        <translation>交错圆点阵</translation>
    </message>
    <message>
        <source>AprilGrid</source>
        <translation>AprilGrid</translation>
    </message>
    <message>
        <source>What is printed on the board</source>
        <translation>标定板上印的图案</translation>
    </message>
    <message>
        <source>Counted on the board, along its long side</source>
        <translation>沿标定板长边数得</translation>
    </message>
    <message>
        <source>Counted on the board, along its short side</source>
        <translation>沿标定板短边数得</translation>
    </message>
    <message>
        <source>How the lens bends rays; fisheye for very wide angles</source>
        <translation>镜头的光线模型；视角很大时用鱼眼</translation>
    </message>
    <message>
        <source>Measured on the printed board, by caliper over several squares</source>
        <translation>在打印的标定板上用卡尺跨多个方格测得</translation>
    </message>
    <message>
        <source>The forecast of the depth&apos;s error is for this distance</source>
        <translation>深度误差的预测针对此距离</translation>
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
        <source>Measured with images of a board</source>
        <translation>用标定板图像测量</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>相机文件</translation>
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
        <translation>使用仿真相机的镜头(&amp;U)</translation>
    </message>
    <message>
        <source>Ima&amp;ges</source>
        <translation>图像(&amp;G)</translation>
    </message>
    <message>
        <source>Folder of board images, or a recording</source>
        <translation>标定板图像的文件夹，或一段录像</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the folder of board images</source>
        <translation>选择标定板图像的文件夹</translation>
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
        <source>The lens is not known yet: choose a camera file, or measure the lens.</source>
        <translation>镜头尚未知：请选择相机文件或进行测量。</translation>
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
        <source>A finger measures through its camera&apos;s lens, so the lens comes first. Measure it once for each camera, with ten to twenty images of a flat board from all sides.</source>
        <translation>手指通过相机镜头测量，所以先要知道镜头。每台相机只需测量一次：从各个方向拍摄十到二十张平面标定板的图像。</translation>
    </message>
    <message>
        <source>Folder of board images</source>
        <translation>标定板图像的文件夹</translation>
    </message>
    <message>
        <source>No folder of images is specified.</source>
        <translation>未指定图像文件夹。</translation>
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
        <source>Live, with a board</source>
        <translation>用标定板实时测量</translation>
    </message>
    <message>
        <source>&amp;Take this board (Space)</source>
        <translation>采集这块板(&amp;T)（空格键）</translation>
    </message>
    <message>
        <source>Takes the board when it is held still at a new position or tilt</source>
        <translation>当标定板在新的位置或倾角上保持不动时自动采集</translation>
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
        <source>Blue: straight lines, as this lens shows them.</source>
        <translation>蓝色：现实中的直线经此镜头所成的像。</translation>
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
        <source>Open the camera as source to take boards live.</source>
        <translation>请把相机打开为来源，即可实时采集标定板。</translation>
    </message>
    <message>
        <source>Looking for the board.</source>
        <translation>正在寻找标定板。</translation>
    </message>
    <message>
        <source>The board is blurred: hold it still or further away.</source>
        <translation>标定板模糊：请拿稳，或拿远一些。</translation>
    </message>
    <message>
        <source>Position already captured: move or tilt the board.</source>
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
        <source>%1 mm per pixel</source>
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
    <message>
        <source>camera.yaml, or a file of ROS, OpenCV, Kalibr, mrcal, PhotonVision or Matlab</source>
        <translation>camera.yaml，或 ROS、OpenCV、Kalibr、mrcal、PhotonVision 或 Matlab 的文件</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</source>
        <translation>相机 (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</translation>
    </message>
    <message>
        <source>Camera file: %1</source>
        <translation>相机文件：%1</translation>
    </message>
    <message>
        <source>Automatically when ne&amp;w and still</source>
        <translation>位置新且静止时自动采集(&amp;W)</translation>
    </message>
    <message>
        <source>Uses a lens that was measured before</source>
        <translation>使用以前测量过的镜头</translation>
    </message>
    <message>
        <source>Images or a video of the board, seen from many sides</source>
        <translation>从多个方向拍摄的标定板图像或视频</translation>
    </message>
    <message>
        <source>Chooses stored images of the board</source>
        <translation>选择已存的标定板图像</translation>
    </message>
    <message>
        <source>Computes the camera file from the views of the board</source>
        <translation>由标定板的各视图计算相机文件</translation>
    </message>
    <message>
        <source>Ends the measurement without a result</source>
        <translation>结束测量，没有结果</translation>
    </message>
    <message>
        <source>The lens of a simulated camera is known exactly</source>
        <translation>模拟相机的镜头是精确已知的</translation>
    </message>
    <message>
        <source>Stores the present image as a view of the board</source>
        <translation>把当前图像存为标定板的一个视图</translation>
    </message>
    <message>
        <source>The lens is measured without it</source>
        <translation>测量镜头时不使用它</translation>
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
        <source>Close</source>
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
        <source>Position of the gripper&apos;s motor; the figures apply to this position.</source>
        <translation>夹爪电机的位置；数值对应于此位置。</translation>
    </message>
    <message>
        <source>Gap and width</source>
        <translation>间隙和宽度</translation>
    </message>
    <message>
        <source>Synchronization of both images</source>
        <translation>两幅图像的同步情况</translation>
    </message>
    <message>
        <source>Waiting for the second image.</source>
        <translation>正在等待第二幅图像。</translation>
    </message>
    <message>
        <source>No capture times: the newest image of each camera.</source>
        <translation>没有拍摄时间：显示两者各自最新的图像。</translation>
    </message>
    <message>
        <source>In sync: 2 was captured %1 ms after 1.</source>
        <translation>同步：2 比 1 晚 %1 ms 拍摄。</translation>
    </message>
    <message>
        <source>Not in sync: 2 was captured %1 ms after 1, more than half a frame.</source>
        <translation>不同步：2 比 1 晚 %1 ms 拍摄，超过半帧。</translation>
    </message>
    <message>
        <source>With a gripper.yaml, the gap between the faces and the width of the held object appear here.</source>
        <translation>有 gripper.yaml 时，此处显示两个接触面之间的间隙和所夹物体的宽度。</translation>
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
        <source>Object width</source>
        <translation>物体宽度</translation>
    </message>
    <message>
        <source>Gap unknown: both faces need depth.</source>
        <translation>间隙未知：两个接触面都需要深度。</translation>
    </message>
    <message>
        <source>No jointly held object.</source>
        <translation>两个手指没有共同夹住任何东西。</translation>
    </message>
    <message>
        <source>Shows another finger with its own camera at the same moment</source>
        <translation>同时显示另一个带相机的手指</translation>
    </message>
    <message>
        <source>Shows the first finger alone again</source>
        <translation>只显示第一个手指</translation>
    </message>
</context>
<context>
    <name>alltact::ContactBox</name>
    <message>
        <source>No image yet.</source>
        <translation>还没有图像。</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Contacts on the finger</source>
        <translation>手指上的接触</translation>
    </message>
</context>
<context>
    <name>alltact::LivePage</name>
    <message>
        <source>Shar&amp;p edges</source>
        <translation>清晰边缘(&amp;P)</translation>
    </message>
    <message>
        <source>Yellow where the image is sharp: turn the lens until most of the face's edges and of the markers are yellow.</source>
        <translation>图像清晰处显示为黄色：转动镜头，直到接触面边缘和标记点大部分变黄。</translation>
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
        <source>change the depth colours</source>
        <translation>更改深度颜色</translation>
    </message>
    <message>
        <source>Image overlays</source>
        <translation>图像叠加</translation>
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
        <source>Ring: visible marker. Dashed diamond: estimated position.</source>
        <translation>圆圈：可见的标记点。虚线菱形：估计的位置。</translation>
    </message>
    <message>
        <source>Stripes falling to the right: too bright to measure. Stripes falling to the left: too dark.</source>
        <translation>向右下的条纹：过亮，无法测量。向左下的条纹：过暗。</translation>
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
        <source>Time per frame</source>
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
        <source>No image yet.</source>
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
        <source>Total</source>
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
    <message>
        <source>Edges &amp;of the face</source>
        <translation>接触面边缘(&amp;O)</translation>
    </message>
    <message>
        <source>Colours e&amp;nd at</source>
        <translation>颜色上限(&amp;N)</translation>
    </message>
    <message>
        <source>Deeper contacts have the colour of the end of the scale</source>
        <translation>更深的接触显示为色标末端的颜色</translation>
    </message>
    <message>
        <source>Both edges of the face, as they are found in this image</source>
        <translation>在此图像中找到的接触面的两条边缘</translation>
    </message>
    <message>
        <source>Arrow: displacement of the finger; it grows with the force</source>
        <translation>箭头：手指的位移，随力增大</translation>
    </message>
    <message>
        <source>How deep the face is pressed in; the scale is in mm</source>
        <translation>接触面被压入的深度；色标单位为 mm</translation>
    </message>
</context>
<context>
    <name>alltact::MainWindow</name>
    <message>
        <source>Fi&amp;nd a command…</source>
        <translation>查找命令(&amp;N)…</translation>
    </message>
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
        <source>continue the last session</source>
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
        <source>A recording is running</source>
        <translation>正在录制</translation>
    </message>
    <message>
        <source>A recording is running. Quitting ends it; the recording up to then is saved.</source>
        <translation>正在录制。退出会结束录制，此前录下的内容会保存。</translation>
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
        <source>Compare with other &amp;methods</source>
        <translation>与其他方法比较(&amp;M)</translation>
    </message>
    <message>
        <source>Calibrates with the same presses by the source paper's method and two others, for the report</source>
        <translation>用同样的按压按原论文的方法和另外两种方法标定，用于报告</translation>
    </message>
    <message>
        <source>Mean residual of the presses: %1 mm, by the source paper's method %2 mm. The report has all methods.</source>
        <translation>按压的平均残差：%1 mm，按原论文的方法为 %2 mm。报告包含所有方法。</translation>
    </message>
    <message>
        <source>The source paper's method finds no calibration with these presses. The report has all methods.</source>
        <translation>原论文的方法用这些按压得不到标定。报告包含所有方法。</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Retains the best solution so far</source>
        <translation>保留目前最好的解</translation>
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
        <source>The calibration is running.</source>
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
        <source>This finger is calibrated. Calibrate again to show the figures.</source>
        <translation>此手指已标定。重新标定可显示图表。</translation>
    </message>
    <message>
        <source>From one press on, the program learns from the ball&apos;s shape what each pixel&apos;s darkening means in mm.</source>
        <translation>只要有一次按压，程序就能根据球的形状学习每个像素变暗对应多少毫米。</translation>
    </message>
    <message>
        <source>From the ball&apos;s shape in all presses, the program learns what each pixel&apos;s darkening means in mm. It leaves out each press once to test how well the others predict it.</source>
        <translation>程序根据全部按压中球的形状，学习每个像素变暗对应多少毫米。每次按压都会被留出一次，以检验其余按压对它的预测效果。</translation>
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
        <source>Result with these presses; not in use yet.</source>
        <translation>使用这些按压得出的结果；尚未启用。</translation>
    </message>
    <message>
        <source>S&amp;how this press</source>
        <translation>显示这次按压(&amp;H)</translation>
    </message>
    <message>
        <source>Click a bar or circle to show this press&apos;s points and position.</source>
        <translation>点击条形或圆圈，可显示该次按压的点和位置。</translation>
    </message>
    <message>
        <source>%1 is left out: the next calibration does not use it.</source>
        <translation>%1 已排除：下次标定不使用它。</translation>
    </message>
    <message>
        <source>%1: its points are marked +, its circle is bold.</source>
        <translation>%1：其点标为 +，其圆圈加粗。</translation>
    </message>
    <message>
        <source>A ball in the layer, seen from its side</source>
        <translation>压入弹性层的球，侧视图</translation>
    </message>
    <message>
        <source>Clear silicone</source>
        <translation>透明硅胶</translation>
    </message>
    <message>
        <source>Untouched face</source>
        <translation>未触碰的表面</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Layer thickness</source>
        <translation>弹性层厚度</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Opens the chosen press on the step Presses</source>
        <translation>在按压步骤中打开所选按压</translation>
    </message>
    <message>
        <source>A press that is left out stays stored; the next calibration does not use it</source>
        <translation>排除的按压仍保存；下次标定不使用它</translation>
    </message>
    <message>
        <source>Computes the mapping from all presses; undo restores the one before</source>
        <translation>由所有按压计算映射；撤销可恢复之前的映射</translation>
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
        <translation>尚无映射：请用球按压标定</translation>
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
        <source>Brightness difference x (relative to untouched)</source>
        <translation>亮度差 x（相对于未触碰）</translation>
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
        <source>Benefit of more data</source>
        <translation>更多数据的收益</translation>
    </message>
    <message>
        <source>Progress of the computation</source>
        <translation>计算进度</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>停止(&amp;P)</translation>
    </message>
    <message>
        <source>Compute no&amp;w</source>
        <translation>立即计算(&amp;W)</translation>
    </message>
    <message>
        <source>Benefit of one more press, more images of each, one more minute. The program paints balls into this finger&apos;s images and calibrates it with them.</source>
        <translation>多一次按压、每次多几张图像或多一分钟的收益。程序在此手指的图像中画入球，并据此重新标定。</translation>
    </message>
    <message>
        <source>No tested option improves the result.</source>
        <translation>所试的选项都不能改善结果。</translation>
    </message>
    <message>
        <source>Calibrates with fewer and with painted presses; takes a minute</source>
        <translation>用较少和绘制的按压标定；约需一分钟</translation>
    </message>
</context>
<context>
    <name>alltact::NewFingerDialog</name>
    <message>
        <source>New finger</source>
        <translation>新建手指</translation>
    </message>
    <message>
        <source>New &amp;folder</source>
        <translation>新文件夹(&amp;F)</translation>
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
        <translation>接触面宽度(&amp;W)</translation>
    </message>
    <message>
        <source>Thickness of the &amp;layer</source>
        <translation>层厚(&amp;L)</translation>
    </message>
    <message>
        <source>Distance of the &amp;plane</source>
        <translation>平面距离(&amp;P)</translation>
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
        <translation>Fin Ray 手指：形状由接触面边缘得出</translation>
    </message>
    <message>
        <source>Flat, rigid sensor</source>
        <translation>平面刚性传感器</translation>
    </message>
    <message>
        <source>detected in the reference recording</source>
        <translation>由参考录像判断</translation>
    </message>
    <message>
        <source>brighter than surroundings</source>
        <translation>比周围亮</translation>
    </message>
    <message>
        <source>darker than surroundings</source>
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
        <source>New folder</source>
        <translation>新文件夹</translation>
    </message>
    <message>
        <source>Camera file</source>
        <translation>相机文件</translation>
    </message>
    <message>
        <source>No folder is chosen.</source>
        <translation>未指定文件夹。</translation>
    </message>
    <message>
        <source>No camera file is specified.</source>
        <translation>未指定相机文件。</translation>
    </message>
    <message>
        <source>Measure width and layer with a caliper, and count the dots. The camera file comes from the lens calibration, the first step of the Calibrate page.</source>
        <translation>用卡尺测量宽度和层厚，并数出标记点。相机文件来自镜头标定，即“标定”页面的第一步。</translation>
    </message>
    <message>
        <source>The first step of the Calibrate page creates it.</source>
        <translation>“标定”页面的第一步会生成它。</translation>
    </message>
    <message>
        <source>Camera (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</source>
        <translation>相机 (*.yaml *.yml *.json *.xml *.cameramodel *.txt)</translation>
    </message>
    <message>
        <source>Untouched image</source>
        <translation>未触碰的图像</translation>
    </message>
    <message>
        <source>&amp;Untouched image</source>
        <translation>未触碰的图像(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Size of a pixel</source>
        <translation>像素尺寸(&amp;S)</translation>
    </message>
    <message>
        <source>from the camera file</source>
        <translation>取自相机文件</translation>
    </message>
    <message>
        <source>On the face, for a camera that looks straight at it</source>
        <translation>表面上的尺寸，适用于正对表面的相机</translation>
    </message>
    <message>
        <source>Choose the untouched image</source>
        <translation>选择未触碰的图像</translation>
    </message>
    <message>
        <source>The finger is not made yet. Discard what was entered?</source>
        <translation>手指尚未创建。要放弃已输入的内容吗？</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>继续输入(&amp;G)</translation>
    </message>
    <message>
        <source>The camera is not described.</source>
        <translation>尚未描述相机。</translation>
    </message>
    <message>
        <source>Choose its file, or enter the size of a pixel and choose the untouched image.</source>
        <translation>请选择相机文件，或输入像素尺寸并选择未触碰的图像。</translation>
    </message>
    <message>
        <source>An image of the face without contact</source>
        <translation>无接触时接触面的图像</translation>
    </message>
    <message>
        <source>Chooses where the finger&apos;s folder is made</source>
        <translation>选择建立手指文件夹的位置</translation>
    </message>
    <message>
        <source>The file that the lens calibration wrote</source>
        <translation>镜头标定写出的文件</translation>
    </message>
    <message>
        <source>Whether the face bends</source>
        <translation>接触面是否弯曲</translation>
    </message>
    <message>
        <source>How the dots differ from the skin around them</source>
        <translation>标记点与周围表皮的明暗差别</translation>
    </message>
    <message>
        <source>From edge to edge, by caliper</source>
        <translation>两边缘之间的宽度，用卡尺测量</translation>
    </message>
    <message>
        <source>Of the translucent layer; no depth is larger</source>
        <translation>半透明层的厚度；深度不会超过它</translation>
    </message>
    <message>
        <source>From the lens to the face</source>
        <translation>镜头到接触面的距离</translation>
    </message>
    <message>
        <source>Counted on one side of the face; 0 for none</source>
        <translation>在接触面一侧数得；没有则为 0</translation>
    </message>
    <message>
        <source>Writes the folder and opens the finger</source>
        <translation>建立文件夹并打开手指</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>关闭此窗口，不作更改（Esc）</translation>
    </message>
</context>
<context>
    <name>alltact::OutlineEditor</name>
    <message>
        <source>Image with the ball&apos;s outline</source>
        <translation>带球轮廓的图像</translation>
    </message>
    <message>
        <source>Drag the outline&apos;s centre or rim onto the ball. Arrow keys move it by a tenth of a pixel, Page Up and Page Down change its size, with Shift by one pixel. Ctrl and the arrow keys move the image; the wheel zooms, over the rim it changes the size.</source>
        <translation>把轮廓的中心或边缘拖到球上。方向键移动十分之一像素，Page Up 和 Page Down 改变大小，加 Shift 为一个像素。Ctrl 加方向键移动图像；滚轮缩放，在边缘上则改变大小。</translation>
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
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Pose of 1…</source>
        <translation>1 的位姿…</translation>
    </message>
    <message>
        <source>Pose of 2…</source>
        <translation>2 的位姿…</translation>
    </message>
    <message>
        <source>Pose of the first finger in the gripper</source>
        <translation>第一个手指在夹爪中的位姿</translation>
    </message>
    <message>
        <source>Pose of the second finger in the gripper</source>
        <translation>第二个手指在夹爪中的位姿</translation>
    </message>
    <message>
        <source>Pose of this finger&apos;s camera in the gripper.</source>
        <translation>该手指的相机在夹爪中的位姿。</translation>
    </message>
    <message>
        <source>Distance between the faces</source>
        <translation>两个接触面之间的距离</translation>
    </message>
    <message>
        <source>Matching of the two recordings</source>
        <translation>两段录像的对应方式</translation>
    </message>
    <message>
        <source>Open a recording first; then you can add a second one.</source>
        <translation>请先打开一段录像，然后可以添加第二段。</translation>
    </message>
    <message>
        <source>Matched by time stamps; 2 was captured %1 ms after 1.</source>
        <translation>按时间戳对应；2 比 1 晚 %1 ms 拍摄。</translation>
    </message>
    <message>
        <source>Recorded at different times, aligned at their starts; 2 was captured %1 ms after 1.</source>
        <translation>录制时间不同，按各自的开头对齐；2 比 1 晚 %1 ms 拍摄。</translation>
    </message>
    <message>
        <source>No time stamps: matched by frame number.</source>
        <translation>没有时间戳：按帧号对应。</translation>
    </message>
    <message>
        <source>Measuring the distance…</source>
        <translation>正在测量距离…</translation>
    </message>
    <message>
        <source>&lt;b&gt;The faces touch or intersect.&lt;/b&gt;</source>
        <translation>&lt;b&gt;两个接触面相碰或相交。&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 mm&lt;/b&gt; shortest distance between the faces, near X %2, Y %3, Z %4 mm</source>
        <translation>两个接触面最近处相距 &lt;b&gt;%1 mm&lt;/b&gt;，位于 X %2、Y %3、Z %4 mm 附近</translation>
    </message>
    <message>
        <source>Shows the first finger alone again</source>
        <translation>只显示第一个手指</translation>
    </message>
    <message>
        <source>Shows another finger of the same moment next to this one</source>
        <translation>在旁边显示同一时刻的另一手指</translation>
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
        <source>Show the entire image</source>
        <translation>显示整个图像</translation>
    </message>
    <message>
        <source>Show the image at original size</source>
        <translation>按原始大小显示</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>Values at the probe</source>
        <translation>探针处的数值</translation>
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
        <source>The source could not be opened; the reason is above.</source>
        <translation>无法打开来源；原因见上方。</translation>
    </message>
    <message>
        <source>No source is open. Choose a camera, a recording or the simulated finger.</source>
        <translation>没有打开的来源。请选择相机、录像或仿真手指。</translation>
    </message>
    <message>
        <source>Waiting for the first image.</source>
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
        <source>Freeze the image</source>
        <translation>定格图像</translation>
    </message>
    <message>
        <source>Freeze this image; measuring continues</source>
        <translation>定格此图像；测量继续进行</translation>
    </message>
    <message>
        <source>Save the image</source>
        <translation>保存图像</translation>
    </message>
    <message>
        <source>Save the image, with or without its overlays</source>
        <translation>保存图像，可包含或不包含叠加内容</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>已定格</translation>
    </message>
    <message>
        <source>As shown (*.png)</source>
        <translation>按当前显示 (*.png)</translation>
    </message>
    <message>
        <source>Only the camera&apos;s image (*.png)</source>
        <translation>仅相机图像 (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose another folder, or free some disk space.</source>
        <translation>无法写入 %1。请选择其他文件夹，或腾出磁盘空间。</translation>
    </message>
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
        <translation>无深度：不在接触面上</translation>
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
    <name>alltact::PageHint</name>
    <message>
        <source>Purpose of this page</source>
        <translation>此页面的用途</translation>
    </message>
    <message>
        <source>How it is &amp;done (F1)</source>
        <translation>操作方法(&amp;D)（F1）</translation>
    </message>
    <message>
        <source>&amp;Understood</source>
        <translation>明白了(&amp;U)</translation>
    </message>
    <message>
        <source>Hides this hint; the help (F1) has it</source>
        <translation>隐藏此提示；帮助 (F1) 中有同样内容</translation>
    </message>
    <message>
        <source>Opens the help of this page</source>
        <translation>打开此页面的帮助</translation>
    </message>
</context>
<context>
    <name>alltact::PointsBox</name>
    <message>
        <source>move point A</source>
        <translation>移动点 A</translation>
    </message>
    <message>
        <source>remove the points</source>
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
        <source>Along the face from its base. The point stays there on the finger when the finger moves.</source>
        <translation>沿接触面，从根部算起。手指运动时，点仍停留在手指上的该处。</translation>
    </message>
    <message>
        <source>Across the face from its centre line.</source>
        <translation>横跨接触面，从中线算起。</translation>
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
        <source>Removes both points.</source>
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
        <translation>无深度：靠近接触面的边缘</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>深度 %1 mm</translation>
    </message>
    <message>
        <source>at the layer&apos;s limit</source>
        <translation>达到层的极限</translation>
    </message>
    <message>
        <source>a bulge at the layer&apos;s limit</source>
        <translation>隆起达到层的极限</translation>
    </message>
    <message>
        <source>beyond the calibrated range</source>
        <translation>超出标定范围</translation>
    </message>
    <message>
        <source>steep: one pixel further changes it by more</source>
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
        <translation>&lt;b&gt;%1&lt;/b&gt;：不在接触面上</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: x %2, y %3, z %4 mm</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;：x %2、y %3、z %4 mm</translation>
    </message>
    <message>
        <source>&lt;b&gt;A to B&lt;/b&gt;: %1 mm straight, %2 mm along the face</source>
        <translation>&lt;b&gt;A 到 B&lt;/b&gt;：直线 %1 mm，沿接触面 %2 mm</translation>
    </message>
    <message>
        <source>offset x %1, y %2, z %3 mm</source>
        <translation>偏移 x %1、y %2、z %3 mm</translation>
    </message>
    <message>
        <source>Deepest %1 mm; contact at x %2, y %3, z %4 mm.</source>
        <translation>最深 %1 mm；接触位置 x %2、y %3、z %4 mm。</translation>
    </message>
    <message>
        <source>Nothing presses on the face.</source>
        <translation>没有物体压在接触面上。</translation>
    </message>
    <message>
        <source>Click on the face for point A, with the right button for point B.</source>
        <translation>在接触面上单击设置 A 点，右键单击设置 B 点。</translation>
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
    <name>alltact::PressCollection</name>
    <message numerus="yes">
        <source>remove %n press(es)</source>
        <translation>
            <numerusform>移除 %n 个按压</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>put %n press(es) back</source>
        <translation>
            <numerusform>恢复使用 %n 个按压</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>leave %n press(es) out</source>
        <translation>
            <numerusform>排除 %n 个按压</numerusform>
        </translation>
    </message>
    <message>
        <source>change the body of %1</source>
        <translation>更改 %1 的物体</translation>
    </message>
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
        <translation>查找 %1 的球</translation>
    </message>
    <message>
        <source>leave out %1</source>
        <translation>排除 %1</translation>
    </message>
    <message>
        <source>put back %1</source>
        <translation>恢复使用 %1</translation>
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
        <source>add %n image(s)</source>
        <translation>
            <numerusform>添加 %n 张图像</numerusform>
        </translation>
    </message>
    <message>
        <source>Presses with these names exist already: %1.</source>
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
        <translation>恢复使用(&amp;P)</translation>
    </message>
    <message>
        <source>Leave o&amp;ut</source>
        <translation>排除(&amp;U)</translation>
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
        <source>at the calibrated position: %1</source>
        <translation>标定给出的位置：%1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mapping minus ball in this press</source>
        <translation>此次按压中映射与球之差</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mapping − ball here:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;此处的映射 − 球：&lt;/b&gt;%1</translation>
    </message>
</context>
<context>
    <name>alltact::PressForm</name>
    <message>
        <source>Another &amp;body</source>
        <translation>其他物体(&amp;B)</translation>
    </message>
    <message>
        <source>Mesh of another body</source>
        <translation>其他物体的网格</translation>
    </message>
    <message>
        <source>A body of known shape pressed in instead of a ball, such as a rod or a printed part: its closed mesh, STL or OBJ in mm. The program finds its pose.</source>
        <translation>代替球压入的已知形状的物体，例如圆杆或打印件：其封闭网格，STL 或 OBJ，单位为 mm。程序会找到它的位姿。</translation>
    </message>
    <message>
        <source>&amp;Choose a mesh…</source>
        <translation>选择网格(&amp;C)…</translation>
    </message>
    <message>
        <source>A &amp;ball</source>
        <translation>球(&amp;B)</translation>
    </message>
    <message>
        <source>Mesh of the body</source>
        <translation>物体的网格</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.STL *.OBJ)</source>
        <translation>网格 (*.stl *.obj *.STL *.OBJ)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Its ball</source>
        <translation>此次所用的球(&amp;I)</translation>
    </message>
    <message>
        <source>Radius of this press&apos;s ball</source>
        <translation>此次按压所用球的半径</translation>
    </message>
    <message>
        <source>If this press was made with a ball of another radius</source>
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
        <source>Indentation depth of the ball from first contact, normal to the face, measured with a stage or a feeler gauge</source>
        <translation>球自刚接触起沿接触面法线方向压入的深度，用位移台或塞尺测得</translation>
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
        <source>Uncertainty of the depth: the standard deviation of its measurement</source>
        <translation>深度的不确定度：测量的标准差</translation>
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
        <source>Step height of a flat punch pressed in instead of a ball; the program then searches for no ball</source>
        <translation>代替球压入的平压头的台阶高度；此时不再查找球</translation>
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
        <source>depths on %1 read %2 % of the true ones</source>
        <translation>%1 上的深度读数为真实值的 %2 %</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>物体 %1</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>已排除：%1</translation>
    </message>
    <message>
        <source>ball set by hand</source>
        <translation>手动设定的球</translation>
    </message>
    <message>
        <source>being analysed</source>
        <translation>正在分析</translation>
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
        <source>%1 mm step measured as %2 mm</source>
        <translation>%1 mm 的台阶测得 %2 mm</translation>
    </message>
    <message>
        <source>a punch with a step of %1 mm</source>
        <translation>台阶为 %1 mm 的压头</translation>
    </message>
    <message>
        <source>depth measured %1 mm, fitted %2 mm</source>
        <translation>深度测得 %1 mm，拟合 %2 mm</translation>
    </message>
    <message>
        <source>no face found</source>
        <translation>未找到接触面</translation>
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
        <source>no disc of a ball</source>
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
        <source>not saved to disk</source>
        <translation>未保存到磁盘</translation>
    </message>
    <message>
        <source>%1 mm deep, error unknown</source>
        <translation>深 %1 mm，误差未知</translation>
    </message>
</context>
<context>
    <name>alltact::PressesPage</name>
    <message>
        <source>Paused while a press is shown.</source>
        <translation>显示按压时暂停。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>按压</translation>
    </message>
    <message>
        <source>&amp;Add images…</source>
        <translation>添加图像(&amp;A)…</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>移除(&amp;M)</translation>
    </message>
    <message>
        <source>Removes the press and its image (undo restores them)</source>
        <translation>移除按压及其图像（可撤销）</translation>
    </message>
    <message>
        <source>&amp;Live image</source>
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
        <source>Automat&amp;ically when still</source>
        <translation>静止时自动拍摄(&amp;I)</translation>
    </message>
    <message>
        <source>Takes a press as soon as a contact holds still for half a second; both hands stay free</source>
        <translation>接触静止半秒后自动拍摄；双手不必离开</translation>
    </message>
    <message>
        <source>&amp;Find the ball again</source>
        <translation>重新查找球(&amp;F)</translation>
    </message>
    <message>
        <source>Discards the outline position set by hand</source>
        <translation>放弃手动设定的轮廓位置</translation>
    </message>
    <message>
        <source>Yellow: the ball&apos;s outline, dashed if found by the program, solid if set by hand. Blue: where the ball meets the untouched face, roughly the dark disc.</source>
        <translation>黄色：球的轮廓，虚线为程序找到的，实线为手动设定的。蓝色：球与未触碰的接触面相交之处，大致是暗斑。</translation>
    </message>
    <message>
        <source>Position of the ball</source>
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
        <source>Take a press first, best six at different positions.</source>
        <translation>请先拍摄一次按压，最好在六个不同位置各拍一次。</translation>
    </message>
    <message>
        <source>No ball was found in any press yet.</source>
        <translation>还没有在任何按压中找到球。</translation>
    </message>
    <message>
        <source>There is no live image: choose a source.</source>
        <translation>没有实时画面：请选择来源。</translation>
    </message>
    <message>
        <source>The finger cannot be compared with its reference.</source>
        <translation>无法将手指与其参考比较。</translation>
    </message>
    <message>
        <source>The live image does not match this finger.</source>
        <translation>实时画面与此手指不符。</translation>
    </message>
    <message>
        <source>Images of presses</source>
        <translation>按压图像</translation>
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
        <source>At this position, it is pressed in by %1 mm.</source>
        <translation>在此位置，球压入 %1 mm。</translation>
    </message>
    <message>
        <source>At this position, it does not touch the face.</source>
        <translation>在此位置，球没有碰到接触面。</translation>
    </message>
    <message>
        <source>Chosen &amp;press</source>
        <translation>所选按压(&amp;P)</translation>
    </message>
    <message>
        <source>A press that is left out stays with the finger and is not used</source>
        <translation>被排除的按压仍保存在手指中，但不使用</translation>
    </message>
    <message>
        <source>The image is being read.</source>
        <translation>正在读取图像。</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px, %4 mm from the camera</source>
        <translation>中心 u %1 px，v %2 px，半径 %3 px，距相机 %4 mm</translation>
    </message>
    <message>
        <source>No ball is drawn here.</source>
        <translation>这里没有画球。</translation>
    </message>
    <message>
        <source>No press yet. Press the ball in at different positions and depths: base, middle and tip.</source>
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
        <source>%1 is taken: the mean of %2 still images.</source>
        <translation>%1 已拍摄：%2 张静止图像的平均。</translation>
    </message>
    <message>
        <source>%1 is a single image: half a second held still would quarter its noise.</source>
        <translation>%1 只有一张图像：保持静止半秒可使噪声降至四分之一。</translation>
    </message>
    <message>
        <source>&amp;Error under the ball</source>
        <translation>球下的误差(&amp;E)</translation>
    </message>
    <message>
        <source>Shows in colour where the mapping is deeper (red) or shallower (blue) than the ball</source>
        <translation>用颜色显示映射比球更深（红）或更浅（蓝）的位置</translation>
    </message>
    <message>
        <source>Next press position</source>
        <translation>下一次按压位置</translation>
    </message>
    <message>
        <source>Depth, ball or punch</source>
        <translation>深度、球或压头</translation>
    </message>
    <message>
        <source>Press %1</source>
        <translation>按压 %1</translation>
    </message>
    <message>
        <source>Waiting: it is unknown whether something touches the face.</source>
        <translation>等待：无法判断接触面是否被触碰。</translation>
    </message>
    <message>
        <source>Waiting: no contact yet.</source>
        <translation>等待：尚无接触。</translation>
    </message>
    <message>
        <source>Waiting: the contact still moves or gets deeper.</source>
        <translation>等待：接触仍在移动，或正在加深。</translation>
    </message>
    <message>
        <source>Taken. For the next one, lift the ball or move it by 2 mm.</source>
        <translation>已拍摄。请抬起球或移动 2 mm，再进行下一次。</translation>
    </message>
    <message>
        <source>Holds still.</source>
        <translation>保持不动。</translation>
    </message>
    <message>
        <source>Six presses are taken. Tick it again to take six more.</source>
        <translation>已拍摄六次按压。再次勾选可再拍摄六次。</translation>
    </message>
    <message>
        <source>Waiting for the ball&apos;s radius.</source>
        <translation>等待输入球的半径。</translation>
    </message>
    <message>
        <source>Adds stored images of presses; they can be dropped here, too</source>
        <translation>添加已存的按压图像，也可拖放到这里</translation>
    </message>
    <message>
        <source>Shows the camera, for the next press</source>
        <translation>显示相机，用于下一次按压</translation>
    </message>
    <message>
        <source>Your name or initials, stored with the presses</source>
        <translation>您的姓名或缩写，随按压一起保存</translation>
    </message>
    <message>
        <source>Stores the present image as a press of the ball</source>
        <translation>把当前图像存为一次球的按压</translation>
    </message>
    <message>
        <source>For a press with another ball, a known depth, or a punch</source>
        <translation>用于另一球、已知深度或冲头的按压</translation>
    </message>
    <message>
        <source>Shows the press that is chosen in the list</source>
        <translation>显示列表中所选的按压</translation>
    </message>
    <message>
        <source>Half of the diameter that a caliper or the data sheet gives</source>
        <translation>卡尺或数据表所给直径的一半</translation>
    </message>
</context>
<context>
    <name>alltact::PressesPlot</name>
    <message>
        <source>Depth error by number of presses</source>
        <translation>深度误差随按压次数的变化</translation>
    </message>
    <message>
        <source>Nothing is computed yet</source>
        <translation>尚未计算</translation>
    </message>
    <message>
        <source>painted balls, whisker to 95 %</source>
        <translation>画入的球，线段到 95 %</translation>
    </message>
    <message>
        <source>current presses</source>
        <translation>现有的按压</translation>
    </message>
    <message>
        <source>real presses left out</source>
        <translation>留出的真实按压</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>按压次数</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es): %1 mm</source>
        <translation>
            <numerusform>%n 次按压：%1 mm</numerusform>
        </translation>
    </message>
    <message>
        <source>Depth error (mm)</source>
        <translation>深度误差 (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::NotificationBar</name>
    <message>
        <source>The program ended unexpectedly last time.</source>
        <translation>程序上次意外退出。</translation>
    </message>
    <message>
        <source>Your work is saved.</source>
        <translation>之前的工作已保存。</translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation>继续上次的工作(&amp;G)</translation>
    </message>
    <message>
        <source>The foot pedal sends no signal now.</source>
        <translation>现在收不到脚踏开关的信号。</translation>
    </message>
    <message>
        <source>The source has ended; its last image is shown.</source>
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
        <source>Show only the newest</source>
        <translation>只显示最新一条</translation>
    </message>
    <message>
        <source>Show all in full</source>
        <translation>完整显示全部</translation>
    </message>
    <message>
        <source>Does what the message advises</source>
        <translation>执行消息所建议的操作</translation>
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
    <name>alltact::ReadingDialog</name>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Lower limit</source>
        <translation>下限(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Upper limit</source>
        <translation>上限(&amp;U)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>请输入名称。</translation>
    </message>
    <message>
        <source>Another reading has this name.</source>
        <translation>已有同名的测量项。</translation>
    </message>
    <message>
        <source>The lower limit must be below the upper one.</source>
        <translation>下限必须小于上限。</translation>
    </message>
    <message>
        <source>Takes this name and these limits</source>
        <translation>采用此名称和限值</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>关闭此窗口，不作更改（Esc）</translation>
    </message>
    <message>
        <source>Name of the value in tables and reports</source>
        <translation>该值在表格和报告中的名称</translation>
    </message>
    <message>
        <source>A value beyond it fails; near it, the standard deviation decides</source>
        <translation>超出即不合格；接近时由标准差判定</translation>
    </message>
</context>
<context>
    <name>alltact::ReadingPlot</name>
    <message>
        <source>No value was measured</source>
        <translation>未测得数值</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>时间 (s)</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
</context>
<context>
    <name>alltact::RecipeBox</name>
    <message>
        <source>pass</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>无法判定</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测得</translation>
    </message>
    <message>
        <source>no tolerance</source>
        <translation>无公差</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 至 %2 %3</translation>
    </message>
    <message>
        <source>at least %1 %2</source>
        <translation>至少 %1 %2</translation>
    </message>
    <message>
        <source>at most %1 %2</source>
        <translation>至多 %1 %2</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>检测配方</translation>
    </message>
    <message>
        <source>Readings to repeat on every frame, with their tolerances. Select a reading between A and B, then Add to recipe; or open a recipe.</source>
        <translation>在每一帧上重复的测量项及其公差。选择 A、B 之间的一个读数，然后“加入配方”；或打开已有配方。</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>测量项</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Readings of the recipe</source>
        <translation>配方中的测量项</translation>
    </message>
    <message>
        <source>Name, tolerance…</source>
        <translation>名称、公差…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>打开配方…</translation>
    </message>
    <message>
        <source>Save recipe…</source>
        <translation>保存配方…</translation>
    </message>
    <message>
        <source>Inspect all frames…</source>
        <translation>检测所有帧…</translation>
    </message>
    <message>
        <source>Measures the recipe in every frame of the recording</source>
        <translation>在录像的每一帧上执行配方</translation>
    </message>
    <message>
        <source>add a reading to the recipe</source>
        <translation>向配方添加测量项</translation>
    </message>
    <message>
        <source>change a reading of the recipe</source>
        <translation>更改配方中的测量项</translation>
    </message>
    <message>
        <source>remove a reading from the recipe</source>
        <translation>从配方移除测量项</translation>
    </message>
    <message>
        <source>open a recipe</source>
        <translation>打开配方</translation>
    </message>
    <message>
        <source>Open a recipe</source>
        <translation>打开配方</translation>
    </message>
    <message>
        <source>Recipes (*.yaml *.yml)</source>
        <translation>配方 (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>保存配方</translation>
    </message>
    <message>
        <source>Name and limits of the selected reading</source>
        <translation>所选读数的名称和限值</translation>
    </message>
    <message>
        <source>Takes the selected reading out of the recipe</source>
        <translation>从配方中移除所选读数</translation>
    </message>
    <message>
        <source>Replaces the readings by those of a file</source>
        <translation>用文件中的读数替换</translation>
    </message>
    <message>
        <source>Writes the readings to a file, for other recordings and fingers</source>
        <translation>把读数写入文件，用于其他录像和手指</translation>
    </message>
    <message>
        <source>Inspect a folder…</source>
        <translation>检视文件夹…</translation>
    </message>
    <message>
        <source>Measures the recipe in every recording of a folder: one table</source>
        <translation>在文件夹的每个录像中测量该配方：一张表格</translation>
    </message>
</context>
<context>
    <name>alltact::RecordPage</name>
    <message>
        <source>Tick frames that are untouched, and install.</source>
        <translation>勾选未触碰的帧，然后设为参考。</translation>
    </message>
    <message>
        <source>Inspect t&amp;his recording</source>
        <translation>检视此录像(&amp;H)</translation>
    </message>
    <message>
        <source>Bend it in all directions</source>
        <translation>向各个方向弯曲</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Recorded video</source>
        <translation>录制的视频</translation>
    </message>
    <message>
        <source>Recording file</source>
        <translation>录制文件</translation>
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
        <translation>停止设置参考；不作任何更改。</translation>
    </message>
    <message>
        <source>Progress of the installation</source>
        <translation>设置参考的进度</translation>
    </message>
    <message>
        <source>Frames that were left out, with the reason</source>
        <translation>被舍弃的帧及原因</translation>
    </message>
    <message>
        <source>If it was cleaned, painted or replaced, the last reference cannot show what pressed on it.</source>
        <translation>表皮若经过清洁、涂漆或更换，上次的参考就无法显示有什么按压过它。</translation>
    </message>
    <message>
        <source>The &amp;skin was changed since the last reference</source>
        <translation>自上次参考以来表皮已改变(&amp;S)</translation>
    </message>
    <message>
        <source>The markers must be visible to measure its bending.</source>
        <translation>标记点必须可见，才能测量弯曲。</translation>
    </message>
    <message>
        <source>Enough: all directions reached.</source>
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
        <source>An image shows what was found in the recording, and what was not.</source>
        <translation>一张图像显示录像中找到了什么、没找到什么。</translation>
    </message>
    <message>
        <source>Show the image</source>
        <translation>显示图像</translation>
    </message>
    <message>
        <source>Set res&amp;t pose</source>
        <translation>设定静止姿态(&amp;T)</translation>
    </message>
    <message>
        <source>Click when the finger hangs free; bending is measured from here.</source>
        <translation>手指自由悬垂时点击；弯曲从这里算起。</translation>
    </message>
    <message>
        <source>Bending is measured from the rest pose that was set.</source>
        <translation>弯曲从设定的静止姿态算起。</translation>
    </message>
    <message>
        <source>Bending is measured from the middle of all poses.</source>
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
        <translation>正在将录像设为参考。</translation>
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
        <source>A flat sensor has one untouched image instead of a recording.</source>
        <translation>平面传感器只需一张未触碰的图像，不需要录像。</translation>
    </message>
    <message>
        <source>A recording is running.</source>
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
        <source>%n frame(s) did not arrive from the source.</source>
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
        <source>%n frame(s) of this recording are lost.</source>
        <translation>
            <numerusform>本次录制丢失了 %n 帧。</numerusform>
        </translation>
    </message>
    <message>
        <source>Try another disk, or a smaller image.</source>
        <translation>请换用其他磁盘或更小的图像。</translation>
    </message>
    <message>
        <source>Keep it free: bend the finger at its tip, its sides or its back.</source>
        <translation>请勿触碰接触面：从指尖、侧面或背面弯曲手指。</translation>
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
        <source>It is unknown whether something touches the contact face.</source>
        <translation>无法判断接触面是否被触碰。</translation>
    </message>
    <message>
        <source>Open the finger that belongs to this source, and keep both edges of its face in the image.</source>
        <translation>请打开属于此来源的手指，并使其接触面的两条边缘都在画面内。</translation>
    </message>
    <message>
        <source>Without a reference, contact is detected from the preceding frames.</source>
        <translation>没有参考时，根据先前的帧判断是否被触碰。</translation>
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
        <source>It was not twisted; twist it, too, if it twists in use.</source>
        <translation>手指没有扭转过。如果使用中会扭转，也请扭转它。</translation>
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
        <source>Moves this video to the trash and records a new one.</source>
        <translation>把这段视频移到回收站，并重新录制一段。</translation>
    </message>
    <message>
        <source>Follow the outline: %1</source>
        <translation>请跟随轮廓：%1</translation>
    </message>
    <message>
        <source>Video of the bending finger</source>
        <translation>手指弯曲的视频</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with contact are left out.</source>
        <translation>
            <numerusform>有 %n 帧被触碰，已排除。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The expected error is being computed, about %n second(s).</source>
        <translation>
            <numerusform>正在计算预期误差，大约还需 %n 秒。</numerusform>
        </translation>
    </message>
    <message>
        <source>The expected error is being computed.</source>
        <translation>正在计算预期误差。</translation>
    </message>
    <message>
        <source>It cannot be installed: %1</source>
        <translation>无法设为参考：%1</translation>
    </message>
    <message numerus="yes">
        <source>Expected error: half of the references off by less than %1 mm, 95 % by less than %2 mm, from %n frame(s).</source>
        <translation>
            <numerusform>预期误差：一半的参考偏差小于 %1 mm，95 % 小于 %2 mm，来自 %n 帧。</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Ctrl+R, or Space</source>
        <translation>Ctrl+R 或空格键</translation>
    </message>
    <message>
        <source>Something touches the contact face; such frames are left out.</source>
        <translation>有物体触碰接触面；这样的帧会被排除。</translation>
    </message>
    <message>
        <source>&amp;Go to Calibrate</source>
        <translation>前往“标定”(&amp;G)</translation>
    </message>
    <message numerus="yes">
        <source>room for about %n minute(s)</source>
        <translation>
            <numerusform>约可录 %n 分钟</numerusform>
        </translation>
    </message>
    <message>
        <source>Fi&amp;le</source>
        <translation>文件(&amp;L)</translation>
    </message>
    <message>
        <source>Install an e&amp;xisting video…</source>
        <translation>将已有视频设为参考(&amp;X)…</translation>
    </message>
    <message>
        <source>Installed.</source>
        <translation>已安装。</translation>
    </message>
    <message>
        <source>Installed; the finger is being loaded with it.</source>
        <translation>已安装；正在用它加载手指。</translation>
    </message>
    <message>
        <source>Chooses the file to record to</source>
        <translation>选择录制的文件</translation>
    </message>
    <message>
        <source>Depth is measured against it from now on; undo restores the one before</source>
        <translation>此后以它为参考测量深度；撤销可恢复之前的参考</translation>
    </message>
    <message>
        <source>Opens it on the page Inspect</source>
        <translation>在检视页面中打开</translation>
    </message>
    <message>
        <source>There presses of a ball give the depth</source>
        <translation>在那里用球的按压得到深度</translation>
    </message>
    <message>
        <source>Examines a stored recording as if it had just been made</source>
        <translation>像刚录制一样分析已存的录像</translation>
    </message>
    <message>
        <source>The finger keeps its present reference</source>
        <translation>手指保留当前参考</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>What the recording is for</source>
        <translation>录像的用途</translation>
    </message>
    <message>
        <source>A reference shows the bending finger with nothing on its face; a measurement shows what is to be measured.</source>
        <translation>参考展示接触面无物、正在弯曲的手指；测量展示要测量的内容。</translation>
    </message>
    <message>
        <source>Length of the recording</source>
        <translation>录制时长</translation>
    </message>
    <message>
        <source>until stopped</source>
        <translation>直到停止</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>The recording stops by itself after so many seconds; 0: only when it is stopped.</source>
        <translation>录制在这么多秒后自动停止；0：只有手动停止。</translation>
    </message>
    <message>
        <source>The video goes into the finger&apos;s folder. It is neither judged nor installed, so the finger may touch anything.</source>
        <translation>视频保存在手指的文件夹中，既不评估也不设为参考，因此手指可以触碰任何物体。</translation>
    </message>
    <message>
        <source>Saved. A measurement is neither judged nor installed.</source>
        <translation>已保存。测量录像既不评估也不设为参考。</translation>
    </message>
    <message>
        <source>It records</source>
        <translation>正在录制</translation>
    </message>
    <message>
        <source>It does not record</source>
        <translation>未在录制</translation>
    </message>
    <message>
        <source>for </source>
        <comment>before a number of seconds</comment>
        <translation>录 </translation>
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
        <source>Camera: all modes are manual.</source>
        <translation>相机：没有开启自动调节。</translation>
    </message>
    <message>
        <source>Camera: %1 is on and changes the measured brightness. Lock brightness on the Live page, or switch it off there.</source>
        <translation>相机：%1 已开启，会改变所测的亮度。请在“实时”页面锁定亮度，或在那里将其关闭。</translation>
    </message>
    <message numerus="yes">
        <source>Before the first recording: %n to fix</source>
        <translation>
            <numerusform>首次录制之前：有 %n 项需要处理</numerusform>
        </translation>
    </message>
    <message>
        <source>What is checked before the first recording; a click shows or hides it</source>
        <translation>首次录制前的检查项目；单击可显示或隐藏</translation>
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
        <source>Content to save</source>
        <translation>要保存的内容</translation>
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
        <source>Image, PNG (300 dpi)</source>
        <translation>图像，PNG（300 dpi）</translation>
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
    <message>
        <source>Depth map in mm, TIFF</source>
        <translation>毫米深度图，TIFF</translation>
    </message>
    <message>
        <source>What is saved, and in which format</source>
        <translation>保存的内容和格式</translation>
    </message>
    <message>
        <source>Asks for the file to write</source>
        <translation>选择要写入的文件</translation>
    </message>
    <message>
        <source>Ends saving; a video has what was saved so far</source>
        <translation>停止保存；视频保留已写入的部分</translation>
    </message>
</context>
<context>
    <name>alltact::SecondCameraDialog</name>
    <message>
        <source>The second finger&apos;s folder</source>
        <translation>第二个手指的文件夹</translation>
    </message>
    <message>
        <source>Source of the second finger</source>
        <translation>第二个手指的来源</translation>
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
        <source>Another finger of the same gripper with its own camera. Both images are shown for the same moment. With a gripper.yaml, the gap between the faces and the width of the held object are shown, too.</source>
        <translation>同一夹爪的另一个手指，带有自己的相机。两幅图像按同一时刻显示。有 gripper.yaml 时，还会显示两个接触面之间的间隙和所夹物体的宽度。</translation>
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
        <source>Choose its camera.</source>
        <translation>请选择观察该手指的相机。</translation>
    </message>
    <message>
        <source>Chooses the folder of the second finger</source>
        <translation>选择第二个手指的文件夹</translation>
    </message>
    <message>
        <source>Chooses a video or a scene instead of a camera</source>
        <translation>选择视频或场景代替相机</translation>
    </message>
    <message>
        <source>Chooses the file that describes the gripper</source>
        <translation>选择描述夹爪的文件</translation>
    </message>
    <message>
        <source>Source of the second finger&apos;s images</source>
        <translation>第二个手指的图像来源</translation>
    </message>
    <message>
        <source>Opens the second finger next to the first</source>
        <translation>在第一个手指旁打开第二个</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>关闭此窗口，不作更改（Esc）</translation>
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
        <source>Image folder of the second finger</source>
        <translation>第二个手指的图像文件夹</translation>
    </message>
    <message>
        <source>Second finger</source>
        <translation>第二个手指</translation>
    </message>
    <message>
        <source>Another finger of the same gripper, with its recording from the same time. Both are shown in the gripper&apos;s coordinate frame; their frames are matched by capture time.</source>
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
        <source>Images…</source>
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
        <source>Choose the finger&apos;s folder.</source>
        <translation>请选择手指文件夹。</translation>
    </message>
    <message>
        <source>Choose its recording.</source>
        <translation>请选择它的录像。</translation>
    </message>
    <message>
        <source>Chooses the folder of the second finger</source>
        <translation>选择第二个手指的文件夹</translation>
    </message>
    <message>
        <source>A video that was recorded at the same time</source>
        <translation>同时录制的视频</translation>
    </message>
    <message>
        <source>A folder of images that were recorded at the same time</source>
        <translation>同时录制的图像文件夹</translation>
    </message>
    <message>
        <source>Opens the second finger next to the first</source>
        <translation>在第一个手指旁打开第二个</translation>
    </message>
    <message>
        <source>Closes this window without a change (Esc)</source>
        <translation>关闭此窗口，不作更改（Esc）</translation>
    </message>
    <message>
        <source>Finger to compare with</source>
        <translation>要比较的手指</translation>
    </message>
    <message>
        <source>Another finger of the same shape, with its recording. Each is measured by its own calibration; the same positions on both faces are compared.</source>
        <translation>另一个形状相同的手指及其录像。各自用自己的标定测量；比较两个接触面上的相同位置。</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>比较(&amp;C)</translation>
    </message>
    <message>
        <source>Shows the difference in depth from this finger</source>
        <translation>显示与该手指的深度差</translation>
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
        <source>From A along the face (mm)</source>
        <translation>从 A 沿接触面的距离 (mm)</translation>
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
        <source>Follow system</source>
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
        <source>Stops using the pedal.</source>
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
        <source>None. A pedal takes presses on Calibrate; on Record it starts and stops.</source>
        <translation>无。脚踏开关在“标定”页面采集按压，在“录制”页面开始和停止录制。</translation>
    </message>
    <message>
        <source>%1: no signal</source>
        <translation>%1：无信号</translation>
    </message>
    <message>
        <source>Colours of all windows</source>
        <translation>所有窗口的颜色</translation>
    </message>
    <message>
        <source>Language of all texts, and the form of numbers and dates</source>
        <translation>所有文字的语言，以及数字和日期的格式</translation>
    </message>
    <message>
        <source>Press the pedal or button after this click</source>
        <translation>单击后踩下踏板或按下按钮</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
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
        <source>Chosen minus in use</source>
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
        <source>One setting gives no depth in this image.</source>
        <translation>其中一种设置在这张图像中没有得出深度。</translation>
    </message>
    <message>
        <source>Difference (mm)</source>
        <translation>差值 (mm)</translation>
    </message>
    <message>
        <source>This image: %1 ms with the setting in use, %2 ms with the chosen one.</source>
        <translation>这张图像：当前设置 %1 ms，所选设置 %2 ms。</translation>
    </message>
    <message>
        <source>No contact: touch the finger to compare depths.</source>
        <translation>没有接触：请触碰手指以比较深度。</translation>
    </message>
    <message>
        <source>Where something presses, half of all points differ by less than %1 mm, 95 % by less than %2 mm.</source>
        <translation>在有按压处，一半的点相差小于 %1 mm，95 % 小于 %2 mm。</translation>
    </message>
</context>
<context>
    <name>alltact::SourceMenu</name>
    <message>
        <source>&amp;Recent sources</source>
        <translation>最近的来源(&amp;R)</translation>
    </message>
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
        <source>Folder of &amp;images…</source>
        <translation>图像文件夹(&amp;I)…</translation>
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
        <source>Open a folder of images</source>
        <translation>打开图像文件夹</translation>
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
        <source>Choose a source</source>
        <translation>选择来源</translation>
    </message>
    <message>
        <source>The source supplies the images. Open a finger before or after.</source>
        <translation>来源提供图像。手指可在此之前或之后打开。</translation>
    </message>
    <message>
        <source>&amp;Simulated finger</source>
        <translation>仿真手指(&amp;S)</translation>
    </message>
    <message>
        <source>Folder of &amp;images…</source>
        <translation>图像文件夹(&amp;I)…</translation>
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
        <source>A full day in five minutes: record, press, calibrate and check a simulated finger</source>
        <translation>五分钟体验完整的一天：录制、按压、标定并检查一个仿真手指</translation>
    </message>
    <message>
        <source>&amp;All fingers…</source>
        <translation>全部手指(&amp;A)…</translation>
    </message>
    <message>
        <source>Verdict and due steps of each, in one list</source>
        <translation>每个手指的结论和待办事项，列在一处</translation>
    </message>
    <message>
        <source>A finger from its side: camera and lamps at its base, and a ball that presses</source>
        <translation>手指的侧视图：根部有相机和灯，一个球正在按压</translation>
    </message>
    <message>
        <source>Vi&amp;deo file…</source>
        <translation>视频文件(&amp;D)…</translation>
    </message>
    <message>
        <source>A computed finger that bends, to try everything without a camera</source>
        <translation>模拟的弯曲手指，无需相机即可试用全部功能</translation>
    </message>
    <message>
        <source>Plays a recording as if it came from a camera</source>
        <translation>像相机一样播放录像</translation>
    </message>
    <message>
        <source>Plays the images of a folder by their names</source>
        <translation>按名称顺序播放文件夹中的图像</translation>
    </message>
    <message>
        <source>Chooses the folder of a finger that exists (Ctrl+O)</source>
        <translation>选择已有手指的文件夹 (Ctrl+O)</translation>
    </message>
    <message>
        <source>Describes a finger that is not calibrated yet (Ctrl+N)</source>
        <translation>描述尚未标定的手指 (Ctrl+N)</translation>
    </message>
    <message>
        <source>Opens the source and the finger of the last time</source>
        <translation>打开上次的来源和手指</translation>
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
        <source>Time per frame</source>
        <translation>每帧用时</translation>
    </message>
    <message>
        <source>%1 ms per frame</source>
        <translation>每帧 %1 ms</translation>
    </message>
    <message>
        <source>%1 frames/s, %2 delivered, %3 shown per second</source>
        <translation>%1 帧/秒，已收到 %2 帧，每秒显示 %3 帧</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>丢失 %n 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (catching up)</source>
        <translation>%1（正在追赶）</translation>
    </message>
</context>
<context>
    <name>alltact::StepList</name>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>check again</source>
        <translation>请复查</translation>
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
    <message>
        <source>Opens this step</source>
        <translation>打开此步骤</translation>
    </message>
</context>
<context>
    <name>alltact::SurfaceBox</name>
    <message>
        <source>Roughness without</source>
        <translation>粗糙度不含</translation>
    </message>
    <message>
        <source>a plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>a form of degree 2</source>
        <translation>2 次形状</translation>
    </message>
    <message>
        <source>a form of degree 3</source>
        <translation>3 次形状</translation>
    </message>
    <message>
        <source>a form of degree 4</source>
        <translation>4 次形状</translation>
    </message>
    <message>
        <source>Form that is no roughness</source>
        <translation>不计入粗糙度的形状</translation>
    </message>
    <message>
        <source>Bends of the finger and of the pressing object do not count as roughness.</source>
        <translation>手指和按压物体的弯曲不计入粗糙度。</translation>
    </message>
    <message>
        <source>Wavelengths up to</source>
        <translation>波长上限</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Longest wavelength of roughness</source>
        <translation>粗糙度的最长波长</translation>
    </message>
    <message>
        <source>Lambda c: longer waves do not count as roughness (Gaussian filter, ISO 16610-61). Usual: 0.25, 0.8, 2.5 mm.</source>
        <translation>λc：更长的波不计入粗糙度（高斯滤波器，ISO 16610-61）。常用：0.25、0.8、2.5 mm。</translation>
    </message>
    <message>
        <source>change the form that is no roughness</source>
        <translation>更改不计入粗糙度的形状</translation>
    </message>
    <message>
        <source>change the roughness' longest wavelength</source>
        <translation>更改粗糙度的最长波长</translation>
    </message>
    <message>
        <source>without a form of degree %1</source>
        <translation>不含 %1 次形状</translation>
    </message>
    <message>
        <source>wavelengths up to %1 mm</source>
        <translation>波长不超过 %1 mm</translation>
    </message>
    <message>
        <source>Add to recipe</source>
        <translation>加入配方</translation>
    </message>
    <message>
        <source>The selected reading, at these positions, becomes part of the recipe</source>
        <translation>将所选读数及其位置加入检测配方</translation>
    </message>
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
        <source>Two points span a box: a ball&apos;s radius, area, volume and roughness inside; distance, step and angle from A to B.</source>
        <translation>两个点构成一个方框：框内的球半径、面积、体积和粗糙度；从 A 到 B 的距离、台阶和角度。</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>复制为文本</translation>
    </message>
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
        <source>Angle from A to B</source>
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
    <message>
        <source>Puts the readings with their units on the clipboard</source>
        <translation>把读数连同单位复制到剪贴板</translation>
    </message>
    <message>
        <source>Puts the readings on the clipboard for a spreadsheet</source>
        <translation>把读数复制到剪贴板，供电子表格使用</translation>
    </message>
    <message>
        <source>Section&apos;s depth</source>
        <translation>剖面深度</translation>
    </message>
    <message>
        <source>Section&apos;s area</source>
        <translation>剖面面积</translation>
    </message>
    <message>
        <source>Section&apos;s width</source>
        <translation>截面宽度</translation>
    </message>
    <message>
        <source>At half of its depth</source>
        <translation>在一半深度处</translation>
    </message>
</context>
<context>
    <name>alltact::TimeLine</name>
    <message>
        <source>Frame of the recording</source>
        <translation>录像的帧</translation>
    </message>
    <message>
        <source>Current frame</source>
        <translation>当前帧</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>/ %1</translation>
    </message>
    <message>
        <source>Frame name</source>
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
    <message>
        <source>Drag to a frame; arrow keys go frame by frame</source>
        <translation>拖到某一帧；方向键逐帧移动</translation>
    </message>
    <message>
        <source>Number of the shown frame, from 1</source>
        <translation>所示帧的编号，从 1 开始</translation>
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
        <source>Calibrate with these presses and read the verdict.</source>
        <translation>请用这些按压进行标定，并阅读结论。</translation>
    </message>
    <message>
        <source>Check it with three presses, as every week.</source>
        <translation>请像每周那样，用三次按压进行检查。</translation>
    </message>
    <message>
        <source>That was a finger&apos;s full day. View its contacts in 3D.</source>
        <translation>这就是手指完整的一天。请在三维视图中查看它的接触。</translation>
    </message>
    <message>
        <source>Wait:</source>
        <translation>请稍候：</translation>
    </message>
    <message>
        <source>Enter the ball&apos;s radius, 4 mm. Each press that is held still is taken, until there are six.</source>
        <translation>请输入球半径 4 mm。每次保持静止的按压都会自动拍摄，拍满六次为止。</translation>
    </message>
    <message>
        <source>Hides the guide for this finger</source>
        <translation>隐藏此手指的引导</translation>
    </message>
    <message>
        <source>Opens the page of the next step</source>
        <translation>打开下一步的页面</translation>
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
        <translation>正在生成报告。</translation>
    </message>
    <message>
        <source>By zone of the face: %1.</source>
        <translation>按接触面的区域：%1。</translation>
    </message>
    <message>
        <source>These presses give no information on this.</source>
        <translation>这些按压无法提供这方面的信息。</translation>
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
        <source>One sheet to store with the finger, on paper or as PDF</source>
        <translation>一页纸，与手指放在一起，可打印或存为 PDF</translation>
    </message>
    <message>
        <source>Remarks (%1)</source>
        <translation>备注（%1）</translation>
    </message>
    <message>
        <source>The current presses give no calibration: %1</source>
        <translation>用现有按压无法标定：%1</translation>
    </message>
    <message>
        <source>The result of the current presses is being computed.</source>
        <translation>正在计算现有按压的结果。</translation>
    </message>
    <message>
        <source>With the current presses: %1 mm, %2</source>
        <translation>用现有按压：%1 mm，%2</translation>
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
        <source>Calibrated; accuracy not stored</source>
        <translation>已标定；未保存精度</translation>
    </message>
    <message>
        <source>• %1</source>
        <comment>an item of a list</comment>
        <translation>• %1</translation>
    </message>
    <message numerus="yes">
        <source>• %n more at the top of the remarks.</source>
        <translation>
            <numerusform>• 另有 %n 项，列于备注之首。</numerusform>
        </translation>
    </message>
    <message>
        <source>• The presses have changed since: calibrate again.</source>
        <translation>• 此后按压已有改动：请重新标定。</translation>
    </message>
    <message>
        <source>Expected error so far: ±%1 mm.</source>
        <translation>目前的预期误差：±%1 mm。</translation>
    </message>
    <message>
        <source>Based on: %1.</source>
        <translation>依据：%1。</translation>
    </message>
    <message>
        <source>The presses have changed since this calibration.</source>
        <translation>此次标定之后按压已有改动。</translation>
    </message>
    <message>
        <source>Finger %1: verdict on its calibration</source>
        <translation>手指 %1：标定结论</translation>
    </message>
    <message numerus="yes">
        <source>%1, ball of radius %2 mm, %n press(es), AllTact %3</source>
        <translation>
            <numerusform>%1，球半径 %2 mm，%n 次按压，AllTact %3</numerusform>
        </translation>
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
        <source>Position on the face, and the mapping&apos;s error there.</source>
        <translation>接触面上的位置，以及映射在该处的误差。</translation>
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
        <source>%n more press(es) in the report.</source>
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
    <message>
        <source>Resolution: %1.</source>
        <translation>分辨率：%1。</translation>
    </message>
    <message>
        <source>Opens the report of the calibration for the lab book (PDF)</source>
        <translation>打开标定报告，用于实验记录（PDF）</translation>
    </message>
    <message>
        <source>Copies the command that repeats this calibration in a terminal</source>
        <translation>复制可在终端重复此标定的命令</translation>
    </message>
    <message>
        <source>What improves this finger&apos;s depth most now</source>
        <translation>目前最能改进此手指深度的事</translation>
    </message>
    <message>
        <source>Shows the remarks instead of the figures</source>
        <translation>显示备注而不是图</translation>
    </message>
    <message>
        <source>Shows what more presses would bring instead of the figures</source>
        <translation>不显示图，而显示更多按压带来的改进</translation>
    </message>
</context>
<context>
    <name>alltact::ViewBox</name>
    <message>
        <source>frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>the source paper</source>
        <translation>原论文</translation>
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
        <source>View f&amp;rom</source>
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
        <source>&amp;Colours up to</source>
        <translation>颜色上限(&amp;C)</translation>
    </message>
    <message>
        <source>Differe&amp;nce up to</source>
        <translation>差值上限(&amp;N)</translation>
    </message>
    <message>
        <source>Scale &amp;depth</source>
        <translation>深度放大(&amp;D)</translation>
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
        <source>3D needs OpenGL 3.2, which this screen does not support.</source>
        <translation>3D 需要 OpenGL 3.2，此屏幕不支持。</translation>
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
        <source>no comparison</source>
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
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Depth at which the colours end</source>
        <translation>颜色上限对应的深度</translation>
    </message>
    <message>
        <source>Difference at both ends of the colour scale</source>
        <translation>色标两端对应的差值</translation>
    </message>
    <message>
        <source> times</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Factor by which depth is drawn larger</source>
        <translation>深度的放大倍数</translation>
    </message>
    <message>
        <source>show as %1</source>
        <translation>显示为%1</translation>
    </message>
    <message>
        <source>view from: %1</source>
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
        <source>scale the depth</source>
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
    <message>
        <source>Finger&apos;s bod&amp;y</source>
        <translation>手指本体(&amp;Y)</translation>
    </message>
    <message>
        <source>Untouched face</source>
        <translation>未触碰的接触面</translation>
    </message>
    <message>
        <source>another recording</source>
        <translation>另一段录像</translation>
    </message>
    <message>
        <source>a body (STL, OBJ)</source>
        <translation>一个物体（STL、OBJ）</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>%2 的第 %1 帧</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>文件(&amp;I)</translation>
    </message>
    <message>
        <source>Choose another file. An image stands for all the images in its folder.</source>
        <translation>选择另一个文件。一张图像代表其文件夹中的所有图像。</translation>
    </message>
    <message>
        <source>Body to compare with, in mm</source>
        <translation>用于比较的物体（毫米）</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.STL *.OBJ)</source>
        <translation>网格 (*.stl *.obj *.STL *.OBJ)</translation>
    </message>
    <message>
        <source>Recording to compare with</source>
        <translation>用于比较的录像</translation>
    </message>
    <message>
        <source>Shows another measurement next to this one, or the difference of both</source>
        <translation>并排显示另一测量，或两者之差</translation>
    </message>
    <message>
        <source>Where the eye is; drag in the view to turn it</source>
        <translation>视点位置；在视图中拖动可转动</translation>
    </message>
    <message>
        <source>Deeper contacts have the colour of the end of the scale</source>
        <translation>更深的接触显示为色标末端的颜色</translation>
    </message>
    <message>
        <source>Larger differences have the colours of the ends of the scale</source>
        <translation>更大的差别显示为色标两端的颜色</translation>
    </message>
    <message>
        <source>Draws depth larger in 3D; measured values do not change</source>
        <translation>在三维中放大显示深度；测量值不变</translation>
    </message>
    <message>
        <source>The same frame, measured with this setting</source>
        <translation>用此设置测量同一帧</translation>
    </message>
    <message>
        <source>Number of the frame to compare with, from 1</source>
        <translation>比较帧的编号，从 1 开始</translation>
    </message>
    <message>
        <source>Side faces, back and base of the finger, in 3D</source>
        <translation>手指的侧面、背面和根部（三维）</translation>
    </message>
    <message>
        <source>Millimetres along the face, and a stick of a known height, in 3D</source>
        <translation>沿接触面的毫米刻度和已知高度的短杆（三维）</translation>
    </message>
    <message>
        <source>The camera with its axes, from which coordinates count, in 3D</source>
        <translation>相机及其坐标轴，坐标由此算起（三维）</translation>
    </message>
    <message>
        <source>Thin lines where the face lies without contact, in 3D</source>
        <translation>无接触时接触面的位置，以细线表示（三维）</translation>
    </message>
    <message>
        <source>The face in 3D, or its depth over the image</source>
        <translation>三维接触面，或图像上的深度</translation>
    </message>
    <message>
        <source>another finger</source>
        <translation>另一个手指</translation>
    </message>
    <message>
        <source>frame %1 of %2, finger %3</source>
        <translation>%2 的第 %1 帧，手指 %3</translation>
    </message>
    <message>
        <source>The paper&apos;s formulas or another setting measure the same frame again. With another frame, recording or finger, the same positions on the face are compared. A body is turned and shifted until it fits the deeper part of the largest contact; the difference is then the skin&apos;s distance from the body.</source>
        <translation>论文的公式或另一种设置会重新测量同一帧。与另一帧、另一段录像或另一个手指比较时，比较接触面上的相同位置。物体会被旋转和平移，直到与最大接触的较深部分吻合；此时差值为皮肤到物体的距离。</translation>
    </message>
</context>
<context>
    <name>alltact::Workspace</name>
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
    <name>alltact::VerdictText</name>
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
    <name>alltact::en</name>
    <message>
        <source>lambda_c of {} mm is less than five pixels here</source>
        <translation>{} mm 的 λc 在此处不足五个像素</translation>
    </message>
    <message>
        <source>{:.2f} mm or more</source>
        <translation>{:.2f} mm 或更大</translation>
    </message>
    <message>
        <source>the piece is smaller than lambda_c of {} mm</source>
        <translation>该区域小于 {} mm 的 λc</translation>
    </message>
    <message>
        <source>a larger piece, or a smaller lambda_c</source>
        <translation>更大的区域，或更小的 λc</translation>
    </message>
    <message>
        <source>{} of {:.0f}: {}</source>
        <translation>{} / {:.0f}：{}</translation>
    </message>
    <message>
        <source>stopped before all frames were done</source>
        <translation>在处理完所有帧之前已停止</translation>
    </message>
    <message>
        <source>another recording</source>
        <translation>另一段录像</translation>
    </message>
    <message>
        <source>the number is too large</source>
        <translation>数字太大</translation>
    </message>
    <message>
        <source>the readings differ too much to be squared</source>
        <translation>读数相差过大，无法求平方</translation>
    </message>
    <message>
        <source>readings of one unit</source>
        <translation>同一单位的读数</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>为空</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>一个名称</translation>
    </message>
    <message>
        <source>is not above the lower limit</source>
        <translation>不大于下限</translation>
    </message>
    <message>
        <source>a larger number</source>
        <translation>更大的数字</translation>
    </message>
    <message>
        <source>has two of the name '{}'</source>
        <translation>有两个名为“{}”的项</translation>
    </message>
    <message>
        <source>different names</source>
        <translation>不同的名称</translation>
    </message>
    <message>
        <source>has {} entries</source>
        <translation>有 {} 项</translation>
    </message>
    <message>
        <source>one to {} readings</source>
        <translation>1 至 {} 个测量项</translation>
    </message>
    <message>
        <source>the frame does not show both positions</source>
        <translation>该帧未显示两个位置</translation>
    </message>
    <message>
        <source>the recording has no frames</source>
        <translation>录像没有帧</translation>
    </message>
    <message numerus="yes">
        <source>{0} earlier checks are left out, so that each finger has as many by each operator.</source>
        <comment>{0} earlier check is left out, so that each finger has as many by each operator.</comment>
        <translation>
            <numerusform>为使每个手指由每位操作者检查的次数相同，{0} 次较早的检查未计入。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{1}: {0} checks of another calibration or without an operator are left out.</source>
        <comment>{1}: {0} check of another calibration or without an operator is left out.</comment>
        <translation>
            <numerusform>{1}：{0} 次检查属于其他标定或没有操作者，未计入。</numerusform>
        </translation>
    </message>
    <message>
        <source>each operator measures each part two times or more</source>
        <translation>每位操作者至少测量每个零件两次</translation>
    </message>
    <message>
        <source>a gage study needs two parts or two operators</source>
        <translation>量具研究需要两个零件或两位操作者</translation>
    </message>
    <message>
        <source>{} by {}</source>
        <translation>{}（{}）</translation>
    </message>
    <message>
        <source>there is no reading of {}</source>
        <translation>缺少 {} 的读数</translation>
    </message>
    <message>
        <source>there is only one reading of {}</source>
        <translation>{} 只有一个读数</translation>
    </message>
    <message>
        <source>there are {} readings of {}, but {} of {}</source>
        <translation>有 {} 个 {} 的读数，但 {} 个 {} 的读数</translation>
    </message>
    <message>
        <source>the same number of readings of each part by each operator</source>
        <translation>每位操作者对每个零件的读数个数相同</translation>
    </message>
    <message>
        <source>a reading of {} is no number</source>
        <translation>{} 的一个读数不是数字</translation>
    </message>
    <message>
        <source>leaving it out</source>
        <translation>去掉该读数</translation>
    </message>
    <message>
        <source>Gage R&amp;R: standard deviation {:.4f} mm (95 %: {:.4f} to {:.4f}), {:.1f} % of the variation</source>
        <translation>量具 R&amp;R：标准差 {:.4f} mm（95 %：{:.4f} 至 {:.4f}），占总变差的 {:.1f} %</translation>
    </message>
    <message>
        <source>{}, {:.1f} % of the tolerance.</source>
        <translation>{}，占公差的 {:.1f} %。</translation>
    </message>
    <message>
        <source>a table whose head names part, operator and value_mm</source>
        <translation>表头含 part、operator 和 value_mm 的表格</translation>
    </message>
    <message>
        <source>the cell is empty</source>
        <translation>单元格为空</translation>
    </message>
    <message>
        <source>the table has no rows</source>
        <translation>表格没有数据行</translation>
    </message>
    <message>
        <source>one row for each reading</source>
        <translation>每个读数一行</translation>
    </message>
    <message>
        <source>the same finger is named twice</source>
        <translation>同一手指被指定了两次</translation>
    </message>
    <message>
        <source>naming each finger once</source>
        <translation>每个手指只指定一次</translation>
    </message>
    <message>
        <source>no check of these fingers names its operator</source>
        <translation>这些手指的检查都没有记录操作者</translation>
    </message>
    <message>
        <source>alltact check FINGER --presses ... --operator NAME, two times or more by each operator</source>
        <translation>alltact check FINGER --presses ... --operator NAME，每位操作者两次或更多</translation>
    </message>
    <message>
        <source>only the joint method is compared with others</source>
        <translation>只有联合法才与其他方法比较</translation>
    </message>
    <message>
        <source>leaving --compare out, or --method joint</source>
        <translation>去掉 --compare，或使用 --method joint</translation>
    </message>
    <message>
        <source>stopped; the finger is unchanged</source>
        <translation>已停止；手指未改变</translation>
    </message>
    <message>
        <source>Most frames have no reading: {}. Try: checking the unit and the beginning of the gauge's times.</source>
        <translation>大多数帧没有读数：{}。建议：检查测力计时间的单位和起点。</translation>
    </message>
    <message>
        <source>in millimetres, this body would be {:.3g} mm long</source>
        <translation>以毫米计，该物体长度将为 {:.3g} mm</translation>
    </message>
    <message>
        <source>exporting its mesh in millimetres</source>
        <translation>以毫米为单位导出其网格</translation>
    </message>
    <message>
        <source>only the joint method uses measured depths and bodies other than balls</source>
        <translation>只有联合方法使用测量的深度和球以外的物体</translation>
    </message>
    <message>
        <source>looking for the body in {}</source>
        <translation>正在 {} 中查找物体</translation>
    </message>
    <message>
        <source>its body was left out, because the balls show {:.1f} +- {:.1f} % of the depth that its shape has; check the balls' radius and the body's mesh</source>
        <translation>其物体未使用，因为球显示的深度是其形状深度的 {:.1f} +- {:.1f} %；请检查球的半径和物体的网格</translation>
    </message>
    <message>
        <source>there are only presses of bodies other than balls</source>
        <translation>只有球以外物体的按压</translation>
    </message>
    <message>
        <source>pressing a ball at least once as well: other bodies show the scale of depth, not its curve</source>
        <translation>至少也按压一次球：其他物体显示深度的尺度，而不是其曲线</translation>
    </message>
    <message>
        <source>it was not made with a ball</source>
        <translation>不是用球按压的</translation>
    </message>
    <message>
        <source>stopped before the body was found</source>
        <translation>在找到物体之前已停止</translation>
    </message>
    <message>
        <source>a body with slopes or curves, pressed in until 3 mm of skin rest on it</source>
        <translation>使用带斜面或曲面的物体，压入至 3 mm 的皮肤贴合其上</translation>
    </message>
    <message>
        <source>the body touches too little of the face</source>
        <translation>物体接触的面积太小</translation>
    </message>
    <message>
        <source>the skin is {:.2f} mm off the body in its best pose</source>
        <translation>在最佳位姿下皮肤与物体相差 {:.2f} mm</translation>
    </message>
    <message>
        <source>too little skin rests on the body away from its edges</source>
        <translation>在远离边缘处贴合物体的皮肤太少</translation>
    </message>
    <message>
        <source>the shape of this body leaves the scale of depth open</source>
        <translation>该物体的形状无法确定深度的尺度</translation>
    </message>
    <message>
        <source>the mesh encloses no volume</source>
        <translation>网格没有包围任何体积</translation>
    </message>
    <message>
        <source>a mesh of a solid body</source>
        <translation>使用实体的网格</translation>
    </message>
    <message>
        <source>the image is damaged, truncated, or of a rare kind of TIFF</source>
        <translation>图像损坏、不完整，或是少见的 TIFF 类型</translation>
    </message>
    <message>
        <source>copy it again, or save it as PNG</source>
        <translation>重新复制，或另存为 PNG</translation>
    </message>
    <message>
        <source>it holds no times of its frames: {:.4g} frames per second were assumed</source>
        <translation>未含各帧的时间：按每秒 {:.4g} 帧处理</translation>
    </message>
    <message>
        <source>it states that its brightness is stored as 16 to 235, but {:.0f} % of its pixels are below 9: 0 to 255 was assumed</source>
        <translation>注明亮度范围为 16 到 235，但有 {:.0f} % 的像素低于 9：按 0 到 255 处理</translation>
    </message>
    <message>
        <source>the image is black and white; 8 to 16 bits per pixel are needed</source>
        <translation>图像是黑白二值的；需要每像素 8 到 16 位</translation>
    </message>
    <message>
        <source>whether the layer may give light back beside where it went in; auto: if the brightness around the presses shows it, given three presses or more</source>
        <translation>层是否可能在光进入处的旁边把光送回；auto：有三次或更多按压、且按压周围的亮度显示如此时</translation>
    </message>
    <message>
        <source>light that may spread</source>
        <translation>可能扩散的光</translation>
    </message>
    <message>
        <source>local light</source>
        <translation>局部的光</translation>
    </message>
    <message>
        <source>on a layer that scatters, &apos;auto&apos; is more accurate, most of all with flat and small bodies</source>
        <translation>在散射的层上 &apos;auto&apos; 更准确，对平的和小的物体尤其如此</translation>
    </message>
    <message>
        <source>&apos;auto&apos; takes a few seconds more, and each image of a layer that spreads light some hundredths of a second more</source>
        <translation>&apos;auto&apos; 多用几秒；光会扩散的层，每幅图像多用百分之几秒</translation>
    </message>
    <message>
        <source>must hold an optical_thickness of 0 to {:g} and a width_factor of {:g} to {:g}</source>
        <translation>必须含有 0 到 {} 的 optical_thickness 和 {} 到 {} 的 width_factor</translation>
    </message>
    <message>
        <source>belongs to a moebius along the normal</source>
        <translation>属于沿法线的 moebius</translation>
    </message>
    <message>
        <source>looking for light that spreads</source>
        <translation>查找扩散的光</translation>
    </message>
    <message>
        <source>more presses of different depth, or --light-spread local</source>
        <translation>更多不同深度的按压，或 --light-spread local</translation>
    </message>
    <message>
        <source>the curve of a layer that spreads light</source>
        <translation>光会扩散的层的曲线</translation>
    </message>
    <message>
        <source>the layer spreads light: {:.0f} % comes back where it went in, the rest from about {:.1f} mm around; depth is read with that undone</source>
        <translation>层使光扩散：{} % 在进入处返回，其余来自周围约 {} mm；深度已消除这一影响</translation>
    </message>
    <message>
        <source>{} x {} px is no image size; each side must be 16 to 16384</source>
        <translation>{} x {} px 不是有效的图像尺寸；边长必须为 16 到 16384</translation>
    </message>
    <message>
        <source>the size of the camera&apos;s images, [width, height]</source>
        <translation>相机图像的尺寸，[宽，高]</translation>
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
        <source>the image&apos;s centre, or run &apos;alltact lens&apos;</source>
        <translation>图像中心，或运行 &apos;alltact lens&apos;</translation>
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
        <source>holds a number that no lens has</source>
        <translation>含有镜头不可能有的数</translation>
    </message>
    <message>
        <source>run &apos;alltact lens&apos;</source>
        <translation>运行 &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>belongs to a perspective camera; an orthographic one does not need it</source>
        <translation>属于透视相机；正交相机不需要它</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>去掉它</translation>
    </message>
    <message>
        <source>the distortion folds over inside the image: near its border, one pixel would see two directions</source>
        <translation>畸变在图像内折叠：靠近边缘处一个像素会看到两个方向</translation>
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
        <source>must be two integers</source>
        <translation>必须是两个整数</translation>
    </message>
    <message>
        <source>[width, height] in pixels</source>
        <translation>[宽，高]，单位像素</translation>
    </message>
    <message>
        <source>the lens-to-window air gap in mm</source>
        <translation>镜头与窗口之间的空气间隙，单位 mm</translation>
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
        <source>the index of refraction behind it</source>
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
        <source>&apos;{}&apos; contains a thousands separator: write {}</source>
        <translation>“{}”含有千位分隔符：请写成 {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has &apos;{}&apos; after the number: remove it</source>
        <translation>“{}”在数字后面有“{}”：请去掉</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is in &apos;{}&apos;: give the number in {}</source>
        <translation>“{}”的单位是“{}”：请以 {} 为单位输入</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is too large or too small a number</source>
        <translation>数字“{}”太大或太小</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; can mean {1} or {2}: write {1} or {2}</source>
        <translation>“{0}”可能是 {1} 或 {2}：请写成 {1} 或 {2}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has too many digits after the decimal mark (at most {})</source>
        <translation>“{}”的小数位太多（最多 {} 位）</translation>
    </message>
    <message>
        <source>a comma separates entries here, and &apos;{}&apos; is none</source>
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
        <source>must be an integer from {} to {}</source>
        <translation>必须是 {} 到 {} 之间的整数</translation>
    </message>
    <message>
        <source>{:g} {} is more than typical for {} ({:g} to {:g} {}): check the decimal mark</source>
        <translation>{} {} 大于{}的常见范围（{} 到 {} {}）：请检查小数点</translation>
    </message>
    <message>
        <source>{:g} {} is less than typical for {} ({:g} to {:g} {}): check the decimal mark</source>
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
        <translation>接触面的宽度</translation>
    </message>
    <message>
        <source>the thickness of a layer</source>
        <translation>层的厚度</translation>
    </message>
    <message>
        <source>the distance of a flat face</source>
        <translation>平坦接触面的距离</translation>
    </message>
    <message>
        <source>the depth of a press</source>
        <translation>按压的深度</translation>
    </message>
    <message>
        <source>the uncertainty of a depth</source>
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
        <translation>接触面两条边缘之间的距离，单位 mm</translation>
    </message>
    <message>
        <source>a fin_ray needs a perspective camera: its shape is computed from it</source>
        <translation>fin_ray 需要透视相机：其形状由此计算</translation>
    </message>
    <message>
        <source>pinhole, brown or fisheye</source>
        <translation>pinhole、brown 或 fisheye</translation>
    </message>
    <message>
        <source>must be above 0 and at most 10000: the face is in front of the camera</source>
        <translation>必须大于 0 且不超过 10000：接触面在相机前方</translation>
    </message>
    <message>
        <source>must be a number from -10000 to 10000</source>
        <translation>必须是 -10000 到 10000 的数</translation>
    </message>
    <message>
        <source>the distance of the face from the camera in mm</source>
        <translation>接触面到相机的距离，单位 mm</translation>
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
        <source>must be an integer from 0 to 64</source>
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
        <source>&apos;{}&apos; is not a file in the finger&apos;s folder</source>
        <translation>“{}”不是手指文件夹内的文件</translation>
    </message>
    <message>
        <source>copy the file into the folder and give its name only</source>
        <translation>把文件复制到文件夹中，只写文件名</translation>
    </message>
    <message>
        <source>must be a column of the image and a step of 0.001 to 500 mm</source>
        <translation>必须是图像的一列和 0.001 到 500 mm 的步长</translation>
    </message>
    <message>
        <source>there is either a video with its markers or one image, not both</source>
        <translation>要么是带标记点的视频，要么是一张图像，不能两者都有</translation>
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
        <source>holds a position far outside the image</source>
        <translation>含有远在图像之外的位置</translation>
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
        <source>must be a text of 1 to 200 characters</source>
        <translation>必须是 1 到 200 个字符的文本</translation>
    </message>
    <message>
        <source>what is written on the finger</source>
        <translation>写在手指上的名字</translation>
    </message>
    <message>
        <source>states how a mapping was made, but there is none</source>
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
        <source>must be a list of integers</source>
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
        <source>a fraction of the depth</source>
        <translation>深度的比例</translation>
    </message>
    <message>
        <source>must be two numbers: mm along and across the face</source>
        <translation>必须是两个数：沿接触面纵向和横向的 mm</translation>
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
        <source>could not confirm that the folder is on the disk</source>
        <translation>无法确认文件夹已写到磁盘</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>其文件夹不存在</translation>
    </message>
    <message>
        <source>create the folder first, or check the path for typing errors</source>
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
        <source>could not create the folder</source>
        <translation>无法建立文件夹</translation>
    </message>
    <message>
        <source>a shorter USB cable or another port; if it persists, another format or a lower rate</source>
        <translation>换短一些的 USB 线或另一接口；若仍如此，换一种格式或降低帧率</translation>
    </message>
    <message>
        <source>a frame arrived with {} of {} bytes</source>
        <translation>收到的帧只有 {} / {} 字节</translation>
    </message>
    <message>
        <source>a {}x{} frame arrived instead of {}x{}</source>
        <translation>收到 {}x{} 的帧，而约定为 {}x{}</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>另一个程序</translation>
    </message>
    <message>
        <source>already in use by {0}</source>
        <translation>正被 {0} 使用</translation>
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
        <source>could not be locked</source>
        <translation>无法锁定</translation>
    </message>
    <message>
        <source>the image header gives {} x {} px; a side must have 1 to {}</source>
        <translation>图像标称 {} x {} px；边长必须为 1 到 {}</translation>
    </message>
    <message>
        <source>a smaller image, or copy it again if that size is wrong</source>
        <translation>使用更小的图像；若尺寸有误请重新复制</translation>
    </message>
    <message>
        <source>the image is damaged or truncated</source>
        <translation>图像已损坏或不完整</translation>
    </message>
    <message>
        <source>copy or record it again</source>
        <translation>重新复制或录制</translation>
    </message>
    <message>
        <source>the image has transparent parts; a camera image has none</source>
        <translation>图像有透明部分；相机图像没有透明部分</translation>
    </message>
    <message>
        <source>the image as the camera took it, without an alpha channel</source>
        <translation>使用相机原图，不带 alpha 通道</translation>
    </message>
    <message>
        <source>the image has {} channels; 1 or 3 are needed</source>
        <translation>图像有 {} 个通道；需要 1 或 3 个</translation>
    </message>
    <message>
        <source>the image as the camera took it</source>
        <translation>使用相机原图</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>cannot write this kind of image ({}) under that name</source>
        <translation>不能用这个名称写入此类图像（{}）</translation>
    </message>
    <message>
        <source>&apos;.png&apos; for 8-bit images, &apos;.tiff&apos; for floating point</source>
        <translation>8 位图像用 &apos;.png&apos;，浮点用 &apos;.tiff&apos;</translation>
    </message>
    <message>
        <source>could not encode the image</source>
        <translation>无法编码图像</translation>
    </message>
    <message>
        <source>a smaller image</source>
        <translation>使用更小的图像</translation>
    </message>
    <message>
        <source>this kind of image cannot be used ({})</source>
        <translation>无法使用此类图像（{}）</translation>
    </message>
    <message>
        <source>8-bit grey images</source>
        <translation>使用 8 位灰度图</translation>
    </message>
    <message>
        <source>the image is in colour: its channels differ from grey by {:.0f} %</source>
        <translation>图像是彩色的：各通道偏离灰色 {} %</translation>
    </message>
    <message>
        <source>an image of the finger under white light</source>
        <translation>使用白光下的手指图像</translation>
    </message>
    <message>
        <source>the image is all black</source>
        <translation>图像全黑</translation>
    </message>
    <message>
        <source>switch on the light, or take off the lens cap</source>
        <translation>打开灯，或取下镜头盖</translation>
    </message>
    <message>
        <source>the image is no 32-bit floating-point TIFF with 1 or 3 channels</source>
        <translation>图像不是 1 或 3 通道的 32 位浮点 TIFF</translation>
    </message>
    <message>
        <source>a depth or points image written by this program</source>
        <translation>使用本程序写出的深度图或点图</translation>
    </message>
    <message>
        <source>the image is truncated</source>
        <translation>图像不完整</translation>
    </message>
    <message>
        <source>the image is damaged</source>
        <translation>图像已损坏</translation>
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
        <source>its parts do not match</source>
        <translation>各部分不衔接</translation>
    </message>
    <message>
        <source>it has no header</source>
        <translation>没有文件头</translation>
    </message>
    <message>
        <source>its header is of an obsolete kind</source>
        <translation>文件头的类型已过时</translation>
    </message>
    <message>
        <source>its width is negative</source>
        <translation>宽度为负</translation>
    </message>
    <message>
        <source>its header contains something that is no number</source>
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
        <source>the file is not an image of a known kind</source>
        <translation>文件不是可识别的图像</translation>
    </message>
    <message>
        <source>PNG, JPEG, BMP, binary PGM or TIFF</source>
        <translation>PNG、JPEG、BMP、二进制 PGM 或 TIFF</translation>
    </message>
    <message>
        <source>no surface can be written under such a name</source>
        <translation>不能用这样的名称写入表面</translation>
    </message>
    <message>
        <source>a name that ends in .ply, .vtp, .stl or .glb</source>
        <translation>以 .ply、.vtp、.stl 或 .glb 结尾的名字</translation>
    </message>
    <message>
        <source>there is no point of the face to write</source>
        <translation>没有可写出的接触面点</translation>
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
        <source>your disk quota is used up</source>
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
        <source>another disk, and check this one</source>
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
        <source>another name for this file</source>
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
        <translation>{}；{}</translation>
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
        <source>this file of the program is missing</source>
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
        <source>move this file away to use the video&apos;s own times</source>
        <translation>移走这个文件，即可使用视频自身的时间</translation>
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
        <source>its pixel format has no brightness</source>
        <translation>其像素格式没有亮度</translation>
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
        <source>it is being recorded or repaired right now</source>
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
        <source>stopped before it was repaired</source>
        <translation>修复完成前已停止</translation>
    </message>
    <message>
        <source>repairing an interrupted recording</source>
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
        <source>the interrupted recording cannot be repaired</source>
        <translation>无法修复中断的录像</translation>
    </message>
    <message>
        <source>wait for its end</source>
        <translation>等它结束</translation>
    </message>
    <message>
        <source>could not restore the recording</source>
        <translation>无法恢复录像</translation>
    </message>
    <message>
        <source>stopped when {} of {} MB of the recording were restored</source>
        <translation>恢复录像 {} / {} MB 时已停止</translation>
    </message>
    <message>
        <source>restoring the removed recording: {} of {} MB</source>
        <translation>正在恢复被删除的录像：{} / {} MB</translation>
    </message>
    <message>
        <source>the disk is nearly full: {} MB are left, {} MB must stay free</source>
        <translation>磁盘将满：剩余 {} MB，须保留 {} MB</translation>
    </message>
    <message>
        <source>free some space, or record to another disk</source>
        <translation>腾出空间，或录制到另一磁盘</translation>
    </message>
    <message>
        <source>the file exists already</source>
        <translation>已有同名文件</translation>
    </message>
    <message>
        <source>another name, or remove the old one</source>
        <translation>换一个名字，或删除旧文件</translation>
    </message>
    <message>
        <source>could not start the recording: its folder does not exist</source>
        <translation>无法开始录制：文件夹不存在</translation>
    </message>
    <message>
        <source>could not start the recording</source>
        <translation>无法开始录制</translation>
    </message>
    <message>
        <source>how images are stored, always without loss: auto stores the camera&apos;s own packets (mjpeg) where available, else magicyuv; ffv1 is about a tenth smaller and four times slower to read</source>
        <translation>图像如何存储，均为无损：auto 在相机送出数据包（mjpeg）时直接存储，否则用 magicyuv；ffv1 约小十分之一，但读取慢四倍</translation>
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
        <source>no frame arrived, so nothing was recorded</source>
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
        <source>{}, and it could not be restored ({})</source>
        <translation>{}，而且无法恢复（{}）</translation>
    </message>
    <message>
        <source>record again, and leave the folder alone meanwhile</source>
        <translation>重新录制，期间不要动该文件夹</translation>
    </message>
    <message>
        <source>what was recorded until then was restored</source>
        <translation>到那时为止录制的内容已恢复</translation>
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
        <source>only 8-bit grey images can be recorded</source>
        <translation>只能录制 8 位灰度图</translation>
    </message>
    <message>
        <source>a grey source</source>
        <translation>使用灰度来源</translation>
    </message>
    <message>
        <source>the image is {} x {}, those before were {} x {}</source>
        <translation>图像为 {} x {}，之前的为 {} x {}</translation>
    </message>
    <message>
        <source>one recording for each size</source>
        <translation>每种尺寸单独录制</translation>
    </message>
    <message>
        <source>the source delivers no JPEG packets to store unchanged</source>
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
        <translation>没有找到接触面的两条长边</translation>
    </message>
    <message>
        <source>the image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>light the finger as in its recording; check that the image shows the face from base to tip, with the finger along the image&apos;s width</source>
        <translation>按录制时的方式照亮手指；检查图像是否显示从根部到指尖的接触面，且手指沿图像宽度方向</translation>
    </message>
    <message>
        <source>the face&apos;s edges</source>
        <translation>接触面的边缘</translation>
    </message>
    <message>
        <source>an image in which both long edges of the bright face are visible and lit evenly; check that the lamps are on and that the lens is clean</source>
        <translation>使用能看见明亮接触面两条长边且光照均匀的图像；检查灯是否打开、镜头是否干净</translation>
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
        <translation>接触面的{}边缘只在很少的列中可见</translation>
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
        <translation>接触面的距离在每一列都太不确定</translation>
    </message>
    <message>
        <source>the image is black: its brightest parts reach {} of 255 grey levels; take the cap off the lens, switch the lamps on, or expose longer</source>
        <translation>画面全黑：最亮处只有 255 级灰度中的 {}；请取下镜头盖、打开灯或延长曝光</translation>
    </message>
    <message>
        <source>the image is too bright: {:.0f} % of it is saturated; expose shorter, or dim the lamps</source>
        <translation>画面过亮：{} % 已饱和；请缩短曝光或调暗灯光</translation>
    </message>
    <message>
        <source>the image is blank: every pixel has {} of 255 grey levels, without even camera noise; plug the camera in again</source>
        <translation>画面空白：所有像素都是 255 级灰度中的 {}，连相机噪声都没有；请重新插拔相机</translation>
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
        <source>{:.1f} % of the face, at its end, is hidden in this frame; whether it is in contact there is unknown</source>
        <translation>接触面末端有 {} % 在此帧中被遮挡；该处是否有接触未知</translation>
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
        <source>{:.0f} % of the face is brighter than its reference: this is another finger, or its skin has changed; choose the right finger, or record the reference again</source>
        <translation>接触面的 {} % 比其参考更亮：这是另一个手指，或其表皮已改变；请选择正确的手指，或重新录制参考</translation>
    </message>
    <message>
        <source>only {} recorded images show every marker; at least 2 are needed</source>
        <translation>只有 {} 张录制的图像显示全部标记点；至少需要 2 张</translation>
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
        <source>{} dots were found next to the face, but less than a third of the {} markers fit any pose of the reference recording</source>
        <translation>在接触面旁找到 {} 个点，但 {} 个标记点中不到三分之一与参考录像的任一姿态相符</translation>
    </message>
    <message>
        <source>this pose was never recorded: the nearest reference frame is {:.1f} px away; record the finger bending further in this direction</source>
        <translation>这个姿态没有录制过：最近的参考帧相距 {} px；请录制手指向此方向弯得更多的情形</translation>
    </message>
    <message>
        <source>an image of the size that the finger was calibrated with</source>
        <translation>使用与标定时尺寸相同的图像</translation>
    </message>
    <message>
        <source>the image equals the previous one to the last grey level: the camera is frozen; plug it in again</source>
        <translation>画面的灰度与上一帧完全相同：相机已停止更新；请重新插拔相机</translation>
    </message>
    <message>
        <source>{}.</source>
        <translation>{}。</translation>
    </message>
    <message>
        <source>too little face is visible to estimate the pose from its shape</source>
        <translation>可见的接触面太少，无法由其形状估计姿态</translation>
    </message>
    <message>
        <source>the markers were not found: this pose is estimated from the face&apos;s shape alone, so depth is less certain, and neither twist nor contact is estimated; uncover and light the dots on the side faces</source>
        <translation>未找到标记点：该姿态仅由接触面的形状估计，因此深度不太可靠，也不估计扭转和接触；请露出并照亮侧面上的圆点</translation>
    </message>
    <message>
        <source>few recorded frames are near this pose: its reference is {:.0f} times less certain than typical; record the finger bending slowly through it</source>
        <translation>此姿态附近录制的帧很少：其参考的不确定度是通常的 {} 倍；请录制手指缓慢弯过此姿态的情形</translation>
    </message>
    <message>
        <source>the finger is not calibrated: calibrate it with ball presses</source>
        <translation>手指尚未标定：请用球按压标定</translation>
    </message>
    <message>
        <source>how the face&apos;s edges are located: half-height crossing to a fiftieth of a pixel, or the steepest pixel</source>
        <translation>接触面的边缘如何定位：半高处，精度五十分之一像素，或最陡的整像素</translation>
    </message>
    <message>
        <source>pixel columns averaged into one position on each edge</source>
        <translation>每条边缘上合并为一个位置的像素列数</translation>
    </message>
    <message>
        <source>degree of the smooth curve through each edge of the face</source>
        <translation>通过接触面每条边缘的平滑曲线的次数</translation>
    </message>
    <message>
        <source>whether a change of light since the reference is measured on the untouched skin and removed</source>
        <translation>是否在未触碰的表皮上测量参考之后的光照变化并予以扣除</translation>
    </message>
    <message>
        <source>standard deviation of the smoothing before depth is computed, in pixels; 0: none</source>
        <translation>计算深度前平滑的标准差，单位像素；0：不平滑</translation>
    </message>
    <message>
        <source>depth that counts as contact, in millimetres</source>
        <translation>算作接触的深度，单位毫米</translation>
    </message>
    <message>
        <source>create the reference again from the recording</source>
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
        <source>&apos;{}&apos; is not the last line of a table with {} frames</source>
        <translation>“{}”不是 {} 帧表格的最后一行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not hold valid values of &apos;{}&apos;</source>
        <translation>“{}”中没有“{}”的有效值</translation>
    </message>
    <message>
        <source>marker {} stands where marker {} of {} is expected</source>
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
        <source>marker {} has a different radius or contrast than before</source>
        <translation>标记点 {} 的半径或对比度与之前不同</translation>
    </message>
    <message>
        <source>the table contains no frames</source>
        <translation>表中没有帧</translation>
    </message>
    <message>
        <source>stopped before the reference was read</source>
        <translation>读取参考完成前已停止</translation>
    </message>
    <message>
        <source>reading reference frame {} of {}</source>
        <translation>正在读取第 {} / {} 个参考帧</translation>
    </message>
    <message>
        <source>the face was found in {} of {} recorded images; 2 are needed</source>
        <translation>{1} 张录制图像中有 {0} 张找到了接触面；需要 2 张</translation>
    </message>
    <message>
        <source>the marker table lists frame {} but the recording ends after {} frames</source>
        <translation>标记点表中有第 {} 帧，但录像只有 {} 帧</translation>
    </message>
    <message>
        <source>the recording cannot be read ({})</source>
        <translation>无法读取录像（{}）</translation>
    </message>
    <message>
        <source>the sensor has no untouched image</source>
        <translation>传感器没有未触碰的图像</translation>
    </message>
    <message>
        <source>specify one for the calibration</source>
        <translation>标定时指定一张</translation>
    </message>
    <message>
        <source>the untouched image</source>
        <translation>未触碰的图像</translation>
    </message>
    <message>
        <source>specify the untouched image again</source>
        <translation>重新指定未触碰的图像</translation>
    </message>
    <message>
        <source>the finger has no reference recording</source>
        <translation>手指没有参考录像</translation>
    </message>
    <message>
        <source>record the untouched finger bending and create its reference</source>
        <translation>录制未触碰手指弯曲的过程并生成参考</translation>
    </message>
    <message>
        <source>the reference recording is missing or not a video</source>
        <translation>参考录像缺失或不是视频</translation>
    </message>
    <message>
        <source>the recording&apos;s image</source>
        <translation>录像的图像</translation>
    </message>
    <message>
        <source>the reference image is not an 8-bit grey image</source>
        <translation>参考图像不是 8 位灰度图</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>save it in this format</source>
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
        <source>depth_mm = {:g} reaches through the layer of {:g} mm</source>
        <translation>depth_mm = {} 穿透了 {} mm 的层</translation>
    </message>
    <message>
        <source>less than finger.face.layer_mm</source>
        <translation>小于 finger.face.layer_mm</translation>
    </message>
    <message>
        <source>s_mm is beyond the ends of the face</source>
        <translation>s_mm 超出接触面的两端</translation>
    </message>
    <message>
        <source>0 to {:g}</source>
        <translation>0 至 {}</translation>
    </message>
    <message>
        <source>y_mm is outside the face</source>
        <translation>y_mm 在接触面之外</translation>
    </message>
    <message>
        <source>{:g} to {:g}</source>
        <translation>{} 至 {}</translation>
    </message>
    <message>
        <source>the ball would sink in past its centre</source>
        <translation>球会陷入超过球心</translation>
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
        <source>nothing is pressed in, so nothing bulges</source>
        <translation>没有压入物，因此没有隆起</translation>
    </message>
    <message>
        <source>add ball or relief</source>
        <translation>添加 ball 或 relief</translation>
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
        <source>unknown lobe</source>
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
        <translation>标记点会切到接触面的边缘</translation>
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
        <source>add the effect sides</source>
        <translation>添加效果 sides</translation>
    </message>
    <message>
        <source>JPEG needs integer grey levels</source>
        <translation>JPEG 需要整数灰度级</translation>
    </message>
    <message>
        <source>add the effect quantisation</source>
        <translation>添加效果 quantisation</translation>
    </message>
    <message>
        <source>no dot would ever be hidden</source>
        <translation>不会有任何点被遮住</translation>
    </message>
    <message>
        <source>leave occlusion out, or use 1 or more</source>
        <translation>去掉 occlusion，或取 1 及以上</translation>
    </message>
    <message>
        <source>{:g} is not a marker number</source>
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
        <source>add the effect markers</source>
        <translation>添加效果 markers</translation>
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
        <source>nothing is pressed in, so nothing rolls off</source>
        <translation>没有压入物，因此没有过渡</translation>
    </message>
    <message>
        <source>kind hertz is for balls only</source>
        <translation>kind hertz 仅适用于球</translation>
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
        <source>a flat sensor does not yield</source>
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
        <source>one pose per frame</source>
        <translation>每帧一个姿态</translation>
    </message>
    <message>
        <source>the motion moves &apos;{}&apos;, but the scene has no such effect</source>
        <translation>运动中有“{}”，但场景中没有相应效果</translation>
    </message>
    <message>
        <source>add `bend` or `sway` to the effects</source>
        <translation>在效果中添加 `bend` 或 `sway`</translation>
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
        <source>add `bend` or `sway` to the effects, or leave the motion out</source>
        <translation>在效果中添加 `bend` 或 `sway`，或去掉运动</translation>
    </message>
    <message>
        <source>scene &apos;{}&apos;: finger.camera</source>
        <translation>场景“{}”：finger.camera</translation>
    </message>
    <message>
        <source>its camera does not deliver integer grey levels</source>
        <translation>其相机给出的不是整数灰度级</translation>
    </message>
    <message>
        <source>this is not [width, height]</source>
        <translation>这不是 [宽，高]</translation>
    </message>
    <message>
        <source>integers from 16 to 16384</source>
        <translation>16 到 16384 的整数</translation>
    </message>
    <message>
        <source>there is no effect &apos;{}&apos;</source>
        <translation>没有效果 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the effect &apos;{}&apos; is listed twice</source>
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
        <source>The layer bulges around the object</source>
        <translation>层在压入物周围隆起</translation>
    </message>
    <message>
        <source>Frames are lost in transmission</source>
        <translation>帧在传输途中丢失</translation>
    </message>
    <message>
        <source>Frames arrive late</source>
        <translation>帧延迟到达</translation>
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
        <source>The camera sends JPEG images</source>
        <translation>相机发送 JPEG 图像</translation>
    </message>
    <message>
        <source>Folds of the side faces hide dots</source>
        <translation>侧面的褶皱遮住标记点</translation>
    </message>
    <message>
        <source>The sensor outputs integer grey levels from 0 to 255</source>
        <translation>传感器输出 0 到 255 的整数灰度级</translation>
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
        <source>The face separates gradually from the object</source>
        <translation>接触面平缓地脱离压入物</translation>
    </message>
    <message>
        <source>Light arrives as photons; their noise grows with brightness</source>
        <translation>光以光子形式到达，其噪声随亮度增大</translation>
    </message>
    <message>
        <source>The side faces of the body are visible</source>
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
        <source>its camera does not deliver integer grey levels in frames {} to {}</source>
        <translation>其相机在第 {} 到 {} 帧给出的不是整数灰度级</translation>
    </message>
    <message>
        <source>add the effect quantisation for all frames</source>
        <translation>请为所有帧添加效果 quantisation</translation>
    </message>
    <message>
        <source>the effect &apos;{}&apos; is listed twice for frames {} to {}</source>
        <translation>效果 &apos;{}&apos; 在第 {} 到 {} 帧出现两次</translation>
    </message>
    <message>
        <source>end one with &apos;until&apos; before the other begins with &apos;from&apos;</source>
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
        <source>it would never be active, for it begins with frame {}</source>
        <translation>它永远不会生效，因为它从第 {} 帧开始</translation>
    </message>
    <message>
        <source>a later frame, or leave the effect out</source>
        <translation>更晚的帧，或者去掉该效果</translation>
    </message>
    <message>
        <source>the key frame before it has the same time</source>
        <translation>前一个关键帧的时间相同</translation>
    </message>
    <message>
        <source>a later time, or leave one of the two out</source>
        <translation>更晚的时间，或者去掉其中一个</translation>
    </message>
    <message>
        <source>the key frame before it has a later time</source>
        <translation>前一个关键帧的时间更晚</translation>
    </message>
    <message>
        <source>key frames in order of time</source>
        <translation>按时间顺序排列关键帧</translation>
    </message>
    <message>
        <source>this is not text</source>
        <translation>这不是文本</translation>
    </message>
    <message>
        <source>a word or a sentence</source>
        <translation>单词或句子</translation>
    </message>
    <message>
        <source>one number per frame</source>
        <translation>每帧一个数</translation>
    </message>
    <message>
        <source>&apos;from&apos; is not below &apos;to&apos;</source>
        <translation>&apos;from&apos; 不小于 &apos;to&apos;</translation>
    </message>
    <message>
        <source>an increasing range</source>
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
        <source>the folder contains no images</source>
        <translation>文件夹中没有图像</translation>
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
        <source>{} changed from {} to {}</source>
        <translation>{} 由 {} 变为 {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not describe a button</source>
        <translation>“{}”没有描述按钮</translation>
    </message>
    <message>
        <source>learn the button again</source>
        <translation>重新学习按钮</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not name a device and its button</source>
        <translation>“{}”没有指明设备及其按钮</translation>
    </message>
    <message>
        <source>&apos;alltact devices --learn-button&apos;, which shows what to write here</source>
        <translation>运行 &apos;alltact devices --learn-button&apos;，它会显示这里该写什么</translation>
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
        <source>no button was pressed and released twice</source>
        <translation>没有按钮被按下并松开两次</translation>
    </message>
    <message>
        <source>another device; a pedal that only clicks must be set to send a key</source>
        <translation>换一个设备；只发送鼠标点击的脚踏开关须设为发送按键</translation>
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
        <source>the device refused the report</source>
        <translation>设备拒绝了该报告</translation>
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
        <source>there is no such HID device; available: {}</source>
        <translation>没有这样的 HID 设备；现有 {}</translation>
    </message>
    <message>
        <source>plug it in; &apos;alltact devices&apos; lists what is found</source>
        <translation>插上设备；&apos;alltact devices&apos; 列出找到的设备</translation>
    </message>
    <message>
        <source>&apos;{}&apos; does not describe a dimmer</source>
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
        <source>the MCP2221A did not answer as expected</source>
        <translation>MCP2221A 的应答不符合预期</translation>
    </message>
    <message>
        <source>plug it in again; close other programs that use it</source>
        <translation>重新插上；关闭使用它的其他程序</translation>
    </message>
    <message>
        <source>this is neither an image, nor a folder of images, nor a video, nor a scene</source>
        <translation>这不是图像、图像文件夹、视频或场景</translation>
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
        <source>it alone, or images only</source>
        <translation>单独使用它，或只用图像</translation>
    </message>
    <message>
        <source>no input was given</source>
        <translation>没有给出输入</translation>
    </message>
    <message>
        <source>specify an image, a folder of images, a video, a scene or a camera</source>
        <translation>指定图像、图像文件夹、视频、场景或相机</translation>
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
        <source>a value within its range; &apos;alltact devices --details&apos; lists the ranges</source>
        <translation>使用范围内的值；&apos;alltact devices --details&apos; 列出范围</translation>
    </message>
    <message>
        <source>an automatic mode controls it</source>
        <translation>正由自动模式控制</translation>
    </message>
    <message>
        <source>switch that mode off first</source>
        <translation>先关闭该自动模式</translation>
    </message>
    <message>
        <source>the camera uses {} instead</source>
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
        <source>it sends its images in several planes, which is not supported</source>
        <translation>它用多个平面传送图像，此处不支持</translation>
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
        <source>it has no supported format</source>
        <translation>它没有受支持的格式</translation>
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
        <source>the camera is not connected</source>
        <translation>相机未连接</translation>
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
        <source>there is no such camera; available: {}</source>
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
        <source>the camera has sent no image for a second</source>
        <translation>相机已有一秒没有发送图像</translation>
    </message>
    <message>
        <source>check the cable and the USB port</source>
        <translation>检查线缆和 USB 接口</translation>
    </message>
    <message>
        <source>this device node delivers no readable images</source>
        <translation>此设备节点不提供可读取的图像</translation>
    </message>
    <message>
        <source>a camera that &apos;alltact devices&apos; lists as usable</source>
        <translation>使用 &apos;alltact devices&apos; 列为可用的相机</translation>
    </message>
    <message>
        <source>the camera stopped sending images</source>
        <translation>相机停止发送图像</translation>
    </message>
    <message>
        <source>no image arrived for {:.1f} seconds</source>
        <translation>已有 {} 秒没有收到图像</translation>
    </message>
    <message>
        <source>check the cable and the USB port; the stream is being restarted</source>
        <translation>检查线缆和 USB 接口；正在重新启动视频流</translation>
    </message>
    <message>
        <source>an image cannot be captured</source>
        <translation>无法采集图像</translation>
    </message>
    <message>
        <source>Images arrive again</source>
        <translation>图像已恢复</translation>
    </message>
    <message>
        <source>the camera is back and has not sent an image yet</source>
        <translation>相机已重新连接，尚未发送图像</translation>
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
        <source>check what is plugged into it, if this was not intended</source>
        <translation>若非有意，请检查它所接的设备</translation>
    </message>
    <message>
        <source>the camera was unplugged</source>
        <translation>相机已拔出</translation>
    </message>
    <message>
        <source>plug it in again; it continues by itself with the same settings</source>
        <translation>重新插上；会自动以相同设置继续</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed from {} to {} by something else</source>
        <translation>“{}”被其他程序从 {} 改为 {}</translation>
    </message>
    <message>
        <source>it was restored</source>
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
        <source>it is not connected</source>
        <translation>它未连接</translation>
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
        <source>another USB port, MJPG instead of YUYV, or smaller images</source>
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
        <source>the camera has no such readable format; it offers {}</source>
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
        <source>this does not answer like a camera</source>
        <translation>它的应答不像相机</translation>
    </message>
    <message>
        <source>the camera&apos;s format cannot be set to {}</source>
        <translation>无法把相机格式设为 {}</translation>
    </message>
    <message>
        <source>{} was requested, but the camera chose {}</source>
        <translation>请求的是 {}，相机却选了 {}</translation>
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
        <source>the camera accepts no buffer</source>
        <translation>相机不接受缓冲区</translation>
    </message>
    <message>
        <source>the camera does not start</source>
        <translation>相机没有启动</translation>
    </message>
    <message>
        <source>the camera provides no buffers</source>
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
        <source>check the brackets, quotes and the space before each key</source>
        <translation>检查括号、引号以及每个键前的空格</translation>
    </message>
    <message>
        <source>is too large to be read</source>
        <translation>太大，无法读取</translation>
    </message>
    <message>
        <source>a file with fewer entries</source>
        <translation>使用条目较少的文件</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;</source>
        <translation>未知的键 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>is unknown, and too large or too unusual to be stored</source>
        <translation>是未知的，而且太大或太不寻常，无法保存</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>删除它</translation>
    </message>
    <message>
        <source>is not known here; it stays unchanged</source>
        <translation>在这里是未知的；保持不变</translation>
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
        <translation>键值块</translation>
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
        <translation>必须是由 &apos;key: value&apos; 行组成的块，而不是{}</translation>
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
        <source>delete one of the two</source>
        <translation>删除其中一个</translation>
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
        <source>write &apos;{}&apos; instead of &apos;{}&apos;</source>
        <translation>把“{1}”写成“{0}”</translation>
    </message>
    <message>
        <source>must be text, not {}</source>
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
        <source>0 means that it is absent; leave out what is absent</source>
        <translation>0 表示没有；没有的项不要写</translation>
    </message>
    <message>
        <source>leave it out, or enter {}</source>
        <translation>去掉它，或填写{}</translation>
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
        <source>must be an integer from {} to {}, not {}</source>
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
        <source>holds {}, which is not text</source>
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
        <source>{}:{}: this line is not a check and is ignored.</source>
        <translation>{}:{}：此行不是检查记录，已忽略。</translation>
    </message>
    <message>
        <source>no untouched image; specify it with --reference to calibrate</source>
        <translation>没有未触碰的图像；标定时请用 --reference 指定</translation>
    </message>
    <message>
        <source>no recording of the untouched finger bending; run alltact reference</source>
        <translation>没有未触碰手指弯曲的录像；请运行 alltact reference</translation>
    </message>
    <message>
        <source>one untouched image</source>
        <translation>一张未触碰的图像</translation>
    </message>
    <message>
        <source>only {} frames; poses between them are estimates, record more bending</source>
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
        <source>no layout at rest, so contact cannot be detected; run alltact reference again</source>
        <translation>没有静止时的排布，无法检测接触；请重新运行 alltact reference</translation>
    </message>
    <message>
        <source>none; the pose comes from the shape of the face, which hides twist</source>
        <translation>没有；姿态由接触面的形状估计，无法得出扭转</translation>
    </message>
    <message>
        <source>{} markers; contact is detected from {:.1f} px of summed offset</source>
        <translation>{} 个标记点；位移总和达 {} px 即判为接触</translation>
    </message>
    <message>
        <source>not calibrated; run alltact calibrate with ball presses</source>
        <translation>未标定；请用球按压运行 alltact calibrate</translation>
    </message>
    <message>
        <source>its origin and quality are not recorded; run alltact calibrate again</source>
        <translation>没有记录它的来源和质量；请重新运行 alltact calibrate</translation>
    </message>
    <message>
        <source>made on an unknown date</source>
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
        <source>{} of {} press images are missing, so the calibration cannot be repeated</source>
        <translation>{1} 张按压图像中缺少 {0} 张，标定无法重复</translation>
    </message>
    <message>
        <source>the stored data is of an interrupted calibration; complete it with {}</source>
        <translation>保存的数据来自一次中断的标定；请用 {} 完成</translation>
    </message>
    <message>
        <source>{} images stored</source>
        <translation>保存了 {} 张图像</translation>
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
        <source>pressing deeper, or a larger image</source>
        <translation>压得更深，或使用更大的图像</translation>
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
        <translation>没有找到接触面</translation>
    </message>
    <message>
        <source>the contacts are not ball-shaped: is the ball or face dirty?</source>
        <translation>接触不是球形：球或接触面脏了吗？</translation>
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
        <source>the mapping reads {:.0f} % too {}: layer, ball or camera have changed</source>
        <translation>映射的读数偏{1} {0} %：层、球或相机已有变化</translation>
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
        <source>the face is {:.1f} % {} than before: check lamps, exposure and layer</source>
        <translation>接触面比从前{1} {0} %：请检查灯、曝光和层</translation>
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
        <source>the finger&apos;s data does not name its calibration ball</source>
        <translation>手指的数据中没有记录标定所用的球</translation>
    </message>
    <message>
        <source>--ball-radius-mm with the radius of the pressed ball</source>
        <translation>用 --ball-radius-mm 给出压入的球的半径</translation>
    </message>
    <message>
        <source>measuring the presses</source>
        <translation>正在测量按压</translation>
    </message>
    <message>
        <source>no press is named &apos;{}&apos;</source>
        <translation>没有叫“{}”的按压</translation>
    </message>
    <message>
        <source>no press can be used: {}</source>
        <translation>没有可用的按压：{}</translation>
    </message>
    <message>
        <source>images of this finger with the ball pressed 0.3 mm or more into its face</source>
        <translation>球压入此手指的接触面 0.3 mm 以上的图像</translation>
    </message>
    <message>
        <source>measuring the presses of the calibration</source>
        <translation>正在测量标定时的按压</translation>
    </message>
    <message>
        <source>the face is {:.1f} % {} than in its reference; false depth {:.3f} mm in its worst 5 % ({:.3f} mm without light correction; up to {:.3f} mm is noise)</source>
        <translation>接触面比录制参考时{1} {0} %；最差的 5 % 处虚假深度为 {2} mm（不作光照校正则为 {3} mm；不超过 {4} mm 属于噪声）</translation>
    </message>
    <message>
        <source>let the lamps warm up, check exposure and gain, and record the reference again if it persists</source>
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
        <translation>没有测得任何结果</translation>
    </message>
    <message>
        <source>none of the images can be compared with the reference</source>
        <translation>没有一张图像能与参考比较</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{}({})</translation>
    </message>
    <message>
        <source>images of the untouched finger in recorded poses</source>
        <translation>未触碰的手指在已录制姿态下的图像</translation>
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
        <source>{} has no camera matrix, so {} cannot describe it</source>
        <translation>{}没有相机矩阵，因此 {} 无法描述它</translation>
    </message>
    <message>
        <source>json, or zip for the entire finger</source>
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
        <source>check its permissions, and that its disk is connected</source>
        <translation>检查其权限，以及磁盘是否已连接</translation>
    </message>
    <message>
        <source>a zip of the finger cannot be in the finger&apos;s own folder</source>
        <translation>手指的 zip 不能放在手指自己的文件夹里</translation>
    </message>
    <message>
        <source>another folder</source>
        <translation>换一个文件夹</translation>
    </message>
    <message>
        <source>stopped before it was written</source>
        <translation>写入完成前已停止</translation>
    </message>
    <message>
        <source>The finger&apos;s reference has changed since its calibration: this is a new calibration.</source>
        <translation>手指的参考与标定时不同：这是一次新的标定。</translation>
    </message>
    <message>
        <source>The finger&apos;s camera, face or markers have changed since its calibration: this is a new calibration.</source>
        <translation>手指的相机、接触面或标记点与标定时不同：这是一次新的标定。</translation>
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
        <translation>标定期间其相机、接触面或标记点被更改</translation>
    </message>
    <message>
        <source>calibrating again</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>only a flat sensor has a single untouched image</source>
        <translation>只有平面传感器才有单张未触碰图像</translation>
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
        <source>is not a checksum of 16 digits</source>
        <translation>不是 16 位的校验和</translation>
    </message>
    <message>
        <source>lists no press</source>
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
        <source>&apos;{}&apos; is not an image name</source>
        <translation>“{}”不是图像名</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a checksum of 16 digits</source>
        <translation>“{}”不是 16 位的校验和</translation>
    </message>
    <message>
        <source>lists &apos;{}&apos; twice</source>
        <translation>“{}”出现两次</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is annotated, but is not among the presses</source>
        <translation>&apos;{}&apos; 有注释，但不在按压之中</translation>
    </message>
    <message>
        <source>remove the annotation</source>
        <translation>请删除该注释</translation>
    </message>
    <message>
        <source>the version of this program that wrote it, or calibrating again with the images in presses/ (this version writes &apos;{}&apos;)</source>
        <translation>使用写出它的程序版本，或用 presses/ 中的图像重新标定（此版本写出“{}”）</translation>
    </message>
    <message>
        <source>there is nothing to repeat: this finger is not calibrated, or by a version that did not store its data</source>
        <translation>没有可重复的内容：此手指未标定，或标定它的版本没有保存所用的数据</translation>
    </message>
    <message>
        <source>calibrating it with the images in presses/ and --ball-radius-mm</source>
        <translation>用 presses/ 中的图像和 --ball-radius-mm 标定</translation>
    </message>
    <message>
        <source>{:.3f} mm, more than three times the others; check the image, or leave it out</source>
        <translation>{} mm，超过其他按压的三倍；请查看图像，或舍弃它</translation>
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
        <source>images of this finger with a ball pressed into its face</source>
        <translation>球压入此手指接触面时的图像</translation>
    </message>
    <message>
        <source>solving</source>
        <translation>正在求解</translation>
    </message>
    <message>
        <source>stopped early: this is the best solution so far, without a report; calibrate again from the stored data to finish it</source>
        <translation>提前停止：这是当时的最佳解，没有报告；用已保存的数据重新标定即可完成</translation>
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
        <source>the reference image</source>
        <translation>参考图像</translation>
    </message>
    <message>
        <source>the untouched image of this sensor, at the size of its presses</source>
        <translation>此传感器未触碰的图像，尺寸与按压图像相同</translation>
    </message>
    <message>
        <source>this is not the image that the finger was calibrated with</source>
        <translation>这不是标定此手指时所用的图像</translation>
    </message>
    <message>
        <source>calibrating again with the existing images</source>
        <translation>用现有的图像重新标定</translation>
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
        <source>giving the images different names; they are stored by name with the finger</source>
        <translation>给图像取不同的名字；它们按名字保存在手指中</translation>
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
        <source>at least one image of a pressed ball</source>
        <translation>至少一张球压入时的图像</translation>
    </message>
    <message>
        <source>none of {} presses could be used: {}</source>
        <translation>{} 次按压都不可用：{}</translation>
    </message>
    <message>
        <source>images in which the ball, and nothing else, is pressed 0.3 mm or more into the face</source>
        <translation>只有球压入接触面 0.3 mm 以上的图像</translation>
    </message>
    <message>
        <source>stopped before there was a solution</source>
        <translation>得到解之前已停止</translation>
    </message>
    <message>
        <source>the ball is {:.1f} mm deep in a layer of {:g} mm</source>
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
        <source>solving: round {}</source>
        <translation>正在求解：第 {} 轮</translation>
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
        <source>the solution is not a valid mapping: {}</source>
        <translation>解不是有效的映射：{}</translation>
    </message>
    <message>
        <source>more presses of different depth, or a lower degree</source>
        <translation>增加不同深度的按压，或降低次数</translation>
    </message>
    <message>
        <source>the balls would be {:.2f} mm deep in a layer of {:.2f} mm</source>
        <translation>球将压入 {:.2f} mm，而层厚只有 {:.2f} mm</translation>
    </message>
    <message>
        <source>checking the layer&apos;s thickness and the ball&apos;s radius, or more presses</source>
        <translation>检查层厚和球半径，或增加按压</translation>
    </message>
    <message>
        <source>one press cannot separate the ball&apos;s depth from the mapping: add presses of different depth at other positions</source>
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
        <source>how presses become a mapping: all balls and the mapping in one fit; or, for comparison, every ball from its dark border alone: by the source paper, as a circle on the face, or as the cone of the ball&apos;s outline</source>
        <translation>如何由按压得到映射：所有球与映射一起拟合；或作为比较，每个球只由其暗区边界得出：按原论文、接触面上的圆，或球轮廓的圆锥</translation>
    </message>
    <message>
        <source>the mapping&apos;s curve; auto: whichever best predicts presses left out</source>
        <translation>映射的曲线；auto：最能预测留出按压的那种</translation>
    </message>
    <message>
        <source>degree of the polynomial; 0: chosen by leaving presses out</source>
        <translation>多项式的次数；0：通过留出按压来选择</translation>
    </message>
    <message>
        <source>the thickness of the layer that brightness follows: along z, along its normal, or that along z projected onto the normal; auto: along the normal unless presses left out show otherwise</source>
        <translation>亮度随层的哪种厚度变化：沿 z、沿法线，或沿 z 再投影到法线；auto：沿法线，除非留出的按压另有结论</translation>
    </message>
    <message>
        <source>whether the mapping may vary slowly over the face, for uneven light or an uneven layer; auto: if presses left out then agree clearly better</source>
        <translation>映射是否可在接触面上缓慢变化，用于光照或层不均匀的情况；auto：当留出的按压因此明显更吻合时</translation>
    </message>
    <message>
        <source>the inner {:.0f} % of each contact&apos;s radius was used, where the skin touches the ball</source>
        <translation>使用了每处接触半径的内侧 {} %，那里表皮贴着球</translation>
    </message>
    <message>
        <source>the inner {:.0f} % of each contact&apos;s radius was used; the skin leaves the ball over {:.2f} mm</source>
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
        <translation>在接触面上变化的{}</translation>
    </message>
    <message>
        <source>its measured depth of {:.3f} +- {:.3f} mm was left out, because the images show {:.3f} +- {:.3f} mm; depth counts from the ball&apos;s first contact, normal to the face</source>
        <translation>其测得的深度 {} +- {} mm 未被采用，因为图像给出 {} +- {} mm；深度从球刚接触处算起，沿接触面的法线方向</translation>
    </message>
    <message>
        <source>its step of {:.3f} mm was left out, because the balls show {:.3f} +- {:.3f} mm; check the balls&apos; radius</source>
        <translation>其台阶 {} mm 未被采用，因为各球给出 {} +- {} mm；请检查球的半径</translation>
    </message>
    <message>
        <source>trying a {}</source>
        <translation>正在尝试：{}</translation>
    </message>
    <message>
        <source>smallest error on presses left out, {:.4f} mm</source>
        <translation>留出按压的误差最小，{} mm</translation>
    </message>
    <message>
        <source>{:.4f} mm on presses left out, not distinguishable from the best ({}, {:.4f} mm) and simpler</source>
        <translation>留出按压误差 {} mm，与最好的（{}，{} mm）无法区分，而且更简单</translation>
    </message>
    <message>
        <source>a single press cannot be left out</source>
        <translation>只有一次按压，无法留出</translation>
    </message>
    <message>
        <source>as requested</source>
        <translation>按要求</translation>
    </message>
    <message>
        <source>the mapping varies over the face, as with uneven light or layer: by {:+.0f} % from the presses nearest the base to those nearest the tip, by {:+.0f} % from side to side; error on presses left out {:.4f} mm, against {:.4f} mm with one mapping for all</source>
        <translation>映射在接触面上有变化，如同光照或层不均匀时：从最靠近根部到最靠近指尖的按压相差 {} %，两侧之间相差 {} %；留出按压误差 {} mm，全部用同一映射则为 {} mm</translation>
    </message>
    <message>
        <source>no circle goes through the dark border</source>
        <translation>没有圆能通过暗区边界</translation>
    </message>
    <message>
        <source>the circle&apos;s centre is off the face</source>
        <translation>圆心不在接触面上</translation>
    </message>
    <message>
        <source>the circle is off the face</source>
        <translation>圆不在接触面上</translation>
    </message>
    <message>
        <source>the circle is larger than the ball</source>
        <translation>圆比球大</translation>
    </message>
    <message>
        <source>{:.0f} degrees of the ball&apos;s outline are visible, a cone needs {:.0f}; the rest of the dark border is where the skin leaves the ball</source>
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
        <source>{}, instead of the paper&apos;s cubic</source>
        <translation>{}，代替论文的三次曲线</translation>
    </message>
    <message>
        <source>in the middle of the face</source>
        <translation>在接触面的中线上</translation>
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
        <source>the scale is least certain: all depths may be too large or too small together, by {:.3f} mm at {:.2f} mm (one standard deviation)</source>
        <translation>最不确定的是比例：所有深度可能一起偏大或偏小，在 {1} mm 处为 {0} mm（一倍标准差）</translation>
    </message>
    <message>
        <source>the relation of shallow to deep is least certain: by {:.3f} mm at {:.2f} mm (one standard deviation), with opposite sign at the other end</source>
        <translation>最不确定的是浅处与深处的关系：在 {1} mm 处为 {0} mm（一倍标准差），另一端符号相反</translation>
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
        <source>a ball 1 % larger than given makes depths {:.1f} % {}; the residual is {:.4f} mm with a radius 1 % smaller, {:.4f} mm as given, {:.4f} mm with one 1 % larger</source>
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
        <source>press next: at another position, 0.5 to 1 mm deep</source>
        <translation>下一次按压：换一处，深 0.5 至 1 mm</translation>
    </message>
    <message>
        <source>press next: {}, {:.1f} mm deep; no press shows whether the mapping holds in that third</source>
        <translation>下一次按压：{}，深 {} mm；还没有按压能说明映射在那三分之一是否成立</translation>
    </message>
    <message>
        <source>enough: another press would reduce the standard deviation of depth from {:.4f} mm to {:.4f} mm at best</source>
        <translation>已足够：再按一次最多把深度标准差从 {} mm 降到 {} mm</translation>
    </message>
    <message>
        <source>press next: {}, {:.1f} mm deep; that would reduce the standard deviation of depth from {:.4f} mm to {:.4f} mm</source>
        <translation>下一次按压：{}，深 {} mm；这会把深度标准差从 {} mm 降到 {} mm</translation>
    </message>
    <message>
        <source>looking for the ball in {}</source>
        <translation>正在 {} 中寻找球</translation>
    </message>
    <message>
        <source>the same image as {}, counted once</source>
        <translation>与 {} 是同一张图像，只计一次</translation>
    </message>
    <message>
        <source>the contact covers too few pixels</source>
        <translation>接触覆盖的像素太少</translation>
    </message>
    <message>
        <source>pressing the punch in until the skin rests on both of its levels, each 4 mm wide or more</source>
        <translation>压入压头，直到表皮贴住它的两个平面，每个平面至少宽 4 mm</translation>
    </message>
    <message>
        <source>the punch touches too little of the face</source>
        <translation>压头与接触面的接触太小</translation>
    </message>
    <message>
        <source>no step is visible</source>
        <translation>看不到台阶</translation>
    </message>
    <message>
        <source>one of the punch&apos;s levels touches too little of the face</source>
        <translation>压头的一个平面与接触面的接触太小</translation>
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
        <source>brightness follows the layer&apos;s thickness {}: error on presses left out {:.4f} mm, against {:.4f} mm along its normal</source>
        <translation>亮度随层{}的厚度变化：留出按压误差 {} mm，沿法线则为 {} mm</translation>
    </message>
    <message>
        <source>unfit for measuring</source>
        <translation>不适合测量</translation>
    </message>
    <message>
        <source>press again with a clean ball of the given radius, entirely on the face</source>
        <translation>请用所给半径的干净球重新按压，使其完全落在接触面上</translation>
    </message>
    <message>
        <source>unproven</source>
        <translation>未经证实</translation>
    </message>
    <message>
        <source>usable for contact and its position</source>
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
        <source>&apos;{}&apos; is not a board; it needs two counts from 3 to 100</source>
        <translation>“{}”不是标定板；需要两个 3 到 100 的数目</translation>
    </message>
    <message>
        <source>9x6 for nine inner corners in a row and six rows</source>
        <translation>9x6 表示每行九个内角点、共六行</translation>
    </message>
    <message>
        <source>the search for the board failed: {}</source>
        <translation>寻找标定板失败：{}</translation>
    </message>
    <message>
        <source>another image</source>
        <translation>换一张图像</translation>
    </message>
    <message>
        <source>only {} different views of the board are left; at least {} are needed</source>
        <translation>只剩 {} 张不同的标定板视图，至少需要 {} 张</translation>
    </message>
    <message>
        <source>{} images or more, with the board tilted and in all parts of the image</source>
        <translation>{} 张以上的图像，标定板要倾斜并遍及画面各处</translation>
    </message>
    <message>
        <source>shows the board exactly where {} shows it</source>
        <translation>标定板的位置与 {} 完全相同</translation>
    </message>
    <message>
        <source>no flat board can look like this</source>
        <translation>平的标定板不可能呈现这种样子</translation>
    </message>
    <message>
        <source>stopped before the lens was estimated</source>
        <translation>得出镜头之前已停止</translation>
    </message>
    <message>
        <source>views that reach into the image&apos;s corners, or another --model</source>
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
        <source>with {} distortion coefficients the lens folds over inside the image or stays undetermined; {} are used</source>
        <translation>用 {} 个畸变系数时，镜头在画面内折叠或无法确定；改用 {} 个</translation>
    </message>
    <message>
        <source>corners scatter by {:.2f} px; good boards give 0.2 or less: check focus, motion, and whether the board is flat</source>
        <translation>角点散布 {} px；好的标定板不超过 0.2：请检查对焦、运动以及板是否平整</translation>
    </message>
    <message>
        <source>stopped before everything was evaluated</source>
        <translation>全部评估完成前已停止</translation>
    </message>
    <message>
        <source>Pattern printed on the board</source>
        <translation>标定板上印的图案</translation>
    </message>
    <message>
        <source>brown up to about 120 degrees of view, fisheye beyond</source>
        <translation>视角约 120 度以内用 brown，更大用 fisheye</translation>
    </message>
    <message>
        <source>Distance of the finger, for errors in mm</source>
        <translation>手指的距离，误差按此距离以 mm 表示</translation>
    </message>
    <message>
        <source>ChArUco: a marker&apos;s side as a fraction of a square&apos;s</source>
        <translation>ChArUco：标记边长占方格边长的比例</translation>
    </message>
    <message>
        <source>all {} views show the board in the same position</source>
        <translation>全部 {} 张视图中标定板都在同一位置</translation>
    </message>
    <message>
        <source>move and tilt the board, or the camera, between images</source>
        <translation>每张图像之间移动并倾斜标定板或相机</translation>
    </message>
    <message>
        <source>estimating a first lens</source>
        <translation>正在估计初始镜头</translation>
    </message>
    <message>
        <source>fitting the lens</source>
        <translation>正在拟合镜头</translation>
    </message>
    <message>
        <source>no {} with {} is visible</source>
        <translation>看不到{}({})</translation>
    </message>
    <message>
        <source>the image has hardly any contrast</source>
        <translation>图像几乎没有对比度</translation>
    </message>
    <message>
        <source>more light, and the board in focus</source>
        <translation>增加光照，并使标定板清晰</translation>
    </message>
    <message>
        <source>a large part of the image is white without detail</source>
        <translation>图像大部分是没有细节的白色</translation>
    </message>
    <message>
        <source>a shorter exposure</source>
        <translation>缩短曝光</translation>
    </message>
    <message>
        <source>the entire board in the image, with its white border, sharp and evenly lit</source>
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
        <source>more of the board in the image, sharp and evenly lit</source>
        <translation>让更多标定板进入画面，清晰且光照均匀</translation>
    </message>
    <message>
        <source>more of the board in the image</source>
        <translation>让更多标定板进入画面</translation>
    </message>
    <message>
        <source>dot grid</source>
        <translation>圆点阵列</translation>
    </message>
    <message>
        <source>a dot of the grid is at the image border or has no contrast</source>
        <translation>阵列中有圆点位于画面边缘或没有对比度</translation>
    </message>
    <message>
        <source>the entire board in the image, evenly lit</source>
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
        <source>large enough to fill the image</source>
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
        <source>no lens model could be fitted to the found corners</source>
        <translation>无法用找到的角点拟合镜头模型</translation>
    </message>
    <message>
        <source>a flat board of the size given with --board, and views that show it tilted</source>
        <translation>使用与 --board 尺寸相符的平板，并有倾斜的视图</translation>
    </message>
    <message>
        <source>no lens model explains the found corners</source>
        <translation>没有镜头模型能解释找到的角点</translation>
    </message>
    <message>
        <source>a flat board of the size given with --board; --model fisheye for a lens wider than 120 degrees</source>
        <translation>使用与 --board 尺寸相符的平板；视角大于 120 度的镜头使用 --model fisheye</translation>
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
        <source>but the views cover too little of the image or too few tilts</source>
        <translation>但视图覆盖的图像范围或倾斜角度不足</translation>
    </message>
    <message>
        <source>with so few views, none could be left out to test the lens</source>
        <translation>视图太少，无法留出任何一张来检验</translation>
    </message>
    <message>
        <source>take {}</source>
        <translation>请拍摄{}</translation>
    </message>
    <message>
        <source>add views, sharp and tilted, that fill the image</source>
        <translation>请增加清晰、倾斜且充满画面的视图</translation>
    </message>
    <message>
        <source>no board was found in any of {} images</source>
        <translation>{} 张图像中都没有找到标定板</translation>
    </message>
    <message>
        <source>{} (the first: {})</source>
        <translation>{}（第一张：{}）</translation>
    </message>
    <message>
        <source>--board and --pattern that match the board, and all of it in the image</source>
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
        <source>is {} x {} px, the images before it {} x {}</source>
        <translation>为 {} x {} px，之前的图像为 {} x {}</translation>
    </message>
    <message>
        <source>images from one camera in one mode; the lens changes with the image size</source>
        <translation>使用同一相机同一模式的图像；镜头参数随图像尺寸而变</translation>
    </message>
    <message>
        <source>another image is called &apos;{}&apos; as well</source>
        <translation>另一张图像也叫“{}”</translation>
    </message>
    <message>
        <source>giving the images different names</source>
        <translation>给图像取不同的名称</translation>
    </message>
    <message>
        <source>its corners are {:.2f} px off the lens model, those of the others {:.2f} px</source>
        <translation>它的角点偏离镜头模型 {} px，其他的为 {} px</translation>
    </message>
    <message>
        <source>blurred, by motion or focus: its edges are {:.1f} px wide, those of the others {:.1f} px</source>
        <translation>因运动或失焦而模糊：边缘宽 {} px，其他的为 {} px</translation>
    </message>
    <message>
        <source>the board is bent; glue it to something stiff</source>
        <translation>标定板弯曲了；请把它贴在硬物上</translation>
    </message>
    <message>
        <source>{} of its {} corners are misplaced: covered, reflected or blurred</source>
        <translation>{1} 个角点中有 {0} 个位置不对：被遮挡、反光或模糊</translation>
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
        <source>the board is not flat and even as assumed: {}; corrected for this, fx would be {:.2f} instead of {:.2f} px; use a board on glass or metal</source>
        <translation>标定板不像假定的那样平整均匀：{}；考虑到这一点，fx 应为 {} 而不是 {} px；请使用玻璃或金属上的标定板</translation>
    </message>
    <message>
        <source>hardly any pixel of the face could be compared with the reference</source>
        <translation>接触面上几乎没有像素能与参考比较</translation>
    </message>
    <message>
        <source>a press and a reference of the same size in which the face is lit</source>
        <translation>使用尺寸相同、接触面已照亮的按压图像和参考</translation>
    </message>
    <message>
        <source>nothing on the face is clearly darker than in the reference (the darkest part differs by {:.1f} %, the rest scatters by {:.1f} %)</source>
        <translation>接触面上没有明显比参考更暗的地方（最暗处相差 {} %，其余散布 {} %）</translation>
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
        <translation>只有球触及接触面的按压</translation>
    </message>
    <message>
        <source>the border of the dark part is not a circular arc</source>
        <translation>暗区的边界不是圆弧</translation>
    </message>
    <message>
        <source>a press in which the ball is entirely on the face</source>
        <translation>球完全落在接触面上的按压</translation>
    </message>
    <message>
        <source>only {:.0f} degrees of the dark disc&apos;s rim are on the face</source>
        <translation>暗斑的边缘只有 {} 度在接触面上</translation>
    </message>
    <message>
        <source>a press closer to the middle of the face</source>
        <translation>更靠近接触面中央的按压</translation>
    </message>
    <message>
        <source>the dark part has a radius of {:.2f} mm, more than the ball&apos;s {:g} mm</source>
        <translation>暗区半径为 {} mm，大于球的 {} mm</translation>
    </message>
    <message>
        <source>checking the ball&apos;s radius, or an image with only the ball in contact</source>
        <translation>检查球的半径，或使用只有球接触的图像</translation>
    </message>
    <message>
        <source>the dark part is not a disc: its rim is off a circle by {:.0f} % of the radius, and {:.0f} % of the circle is dark</source>
        <translation>暗区不是圆盘：边缘偏离圆达半径的 {} %，圆内有 {} % 是暗的</translation>
    </message>
    <message>
        <source>an image in which a ball, and only the ball, touches the face</source>
        <translation>只有一个球触及接触面的图像</translation>
    </message>
    <message>
        <source>the middle of the dark disc is outside the face</source>
        <translation>暗斑的中心不在接触面上</translation>
    </message>
    <message>
        <source>the press has no difference image</source>
        <translation>该按压没有差值图像</translation>
    </message>
    <message>
        <source>taking the image again</source>
        <translation>重新拍摄图像</translation>
    </message>
    <message>
        <source>OpenCV failed: {}</source>
        <translation>OpenCV 出错：{}</translation>
    </message>
    <message>
        <source>the finger moves: at most {} of {} frames in a row are the same</source>
        <translation>手指在动：{1} 帧中连续相同的不超过 {0} 帧</translation>
    </message>
    <message>
        <source>holding ball and finger still for half a second, in steady light</source>
        <translation>在稳定的光照下使球和手指保持静止半秒</translation>
    </message>
    <message>
        <source>the mean of {} still frames, of {} read</source>
        <translation>读取的 {1} 帧中 {0} 个静止帧的平均</translation>
    </message>
    <message>
        <source>the ball that was set by hand does not touch the face</source>
        <translation>手动设置的球没有触及接触面</translation>
    </message>
    <message>
        <source>moving its outline to the dark disc, or automatic detection</source>
        <translation>把轮廓移到暗斑上，或使用自动检测</translation>
    </message>
    <message>
        <source>one for each press, &quot;&quot; for none</source>
        <translation>每次按压一项，没有则写 &quot;&quot;</translation>
    </message>
    <message>
        <source>is not a ball centre in front of the camera</source>
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
        <source>frame {} cannot be the rest pose: {}</source>
        <translation>第 {} 帧不能作为手指的静止姿态：{}</translation>
    </message>
    <message>
        <source>another frame in which the finger rests</source>
        <translation>另一帧手指静止的画面</translation>
    </message>
    <message>
        <source>frame {}: something may have pressed on the contact face, {:.0f} mm from its base ({:.1f} % darker than untouched)</source>
        <translation>第 {} 帧：可能有物体按压接触面，距根部 {} mm（比未触碰时暗 {} %）</translation>
    </message>
    <message>
        <source>frame {}: something pressed on the contact face, {:.0f} mm from its base ({:.0f} % darker than untouched)</source>
        <translation>第 {} 帧：有物体按压接触面，距根部 {} mm（比未触碰时暗 {} %）</translation>
    </message>
    <message>
        <source>frames {} to {}: something may have pressed on the contact face, {:.0f} mm from its base (up to {:.1f} % darker than untouched)</source>
        <translation>第 {} 至 {} 帧：可能有物体按压接触面，距根部 {} mm（比未触碰时最多暗 {} %）</translation>
    </message>
    <message>
        <source>frames {} to {}: something pressed on the contact face, {:.0f} mm from its base (up to {:.0f} % darker than untouched)</source>
        <translation>第 {} 至 {} 帧：有物体按压接触面，距根部 {} mm（比未触碰时最多暗 {} %）</translation>
    </message>
    <message>
        <source>In {} of {} frames the face is darker than in the others. Something pressed on it most of the time, or most poses occur once. All frames stay in use. If there was contact, record again, and show each pose several times</source>
        <translation>{}/{} 帧中，接触面比其余帧更暗。大部分时间有物体按压，或大多数姿态只出现过一次。所有帧仍然使用。如果有物体碰到接触面，请重新录制，并让每个姿态出现多次</translation>
    </message>
    <message>
        <source>In {} of {} frames the face is darker than in the brightest, and so are frames of near poses. Something pressed on it for long, or these poses occur once. They stay in use. If there was contact, record again, and show each pose several times</source>
        <translation>在 {} / {} 帧中接触面比最亮的帧暗，姿态相近的帧也是如此。有物体长时间按压，或这些姿态只出现过一次。这些帧仍然使用。如果有物体碰过接触面，请重新录制，并让每个姿态出现多次</translation>
    </message>
    <message>
        <source>only {} frames are left to use</source>
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
        <source>record again with nothing on the contact face, or specify that its skin has changed</source>
        <translation>在接触面上没有任何物体时重新录制，或注明其表皮此后已改变</translation>
    </message>
    <message>
        <source>something pressed on the contact face {:.0f} mm from its base in {} of {} frames: it is {:.0f} % darker there than in the reference from before</source>
        <translation>接触面距根部 {} mm 处在 {} / {} 帧中有物体按压：该处比先前的参考暗 {} %</translation>
    </message>
    <message>
        <source>in {} of {} presses the face is brighter than its reference {:.0f} mm along it: something pressed there when the reference was recorded; record it again, then calibrate again</source>
        <translation>{} / {} 次按压中，接触面在沿长度 {} mm 处比参考更亮：录制参考时该处有物体按压；请重新录制，然后重新标定</translation>
    </message>
    <message>
        <source>{} frames show poses that occur at no other time; it is unknown whether something pressed on the contact face in them</source>
        <translation>{} 帧的姿态在其他时刻没有出现过；无法确定其中是否有物体按压接触面</translation>
    </message>
    <message>
        <source>No markers can be used: {}. Poses are estimated from the shape of the face alone, without twist. If the finger has dots, light both side faces so that they stand out, and focus</source>
        <translation>没有可用的标记点：{}。姿态仅由接触面的形状估计，不含扭转。若手指有标记点，请照亮两个侧面使其突出，并对好焦</translation>
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
        <source>twist it further to one side</source>
        <translation>再向一个方向扭</translation>
    </message>
    <message>
        <source>twist it further to the other side</source>
        <translation>再向另一方向扭</translation>
    </message>
    <message>
        <source>bend it while its tip is pushed aside: {:.0f} % of the combinations were seen</source>
        <translation>把指尖推向一侧的同时弯曲：已看到 {} % 的组合</translation>
    </message>
    <message>
        <source>a frame shows {} dots on the upper and {} on the lower side face (median of {} frames), but no two rows of up to {} with fixed positions on the finger</source>
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
        <source>the markers are {:.1f} px off any possible position</source>
        <translation>标记点偏离可能的位置 {} px</translation>
    </message>
    <message>
        <source>with {} markers, none may be hidden</source>
        <translation>仅有 {} 个标记点，一个都不能被遮挡</translation>
    </message>
    <message>
        <source>no frame shows the face</source>
        <translation>没有一帧显示接触面</translation>
    </message>
    <message>
        <source>a recording in which both long edges of the bright face are visible</source>
        <translation>能看见明亮接触面两条长边的录像</translation>
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
        <source>a recording from this finger&apos;s camera, or the right camera.size and orientation</source>
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
        <source>writing the accepted frames</source>
        <translation>正在写入采用的帧</translation>
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
        <source>{} frames are few: one minute (about 1500 frames) over all bending directions gives closer references</source>
        <translation>{} 帧偏少：录制一分钟（约 1500 帧）并覆盖所有弯曲方向，可得到更准确的参考</translation>
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
        <source>a flat sensor needs one untouched image</source>
        <translation>平面传感器需要一张未触碰的图像</translation>
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
        <source>only a flat sensor uses one untouched image as its reference</source>
        <translation>只有平面传感器以一张未触碰的图像为参考</translation>
    </message>
    <message>
        <source>a recording of the bending, untouched finger</source>
        <translation>使用未触碰手指弯曲的录像</translation>
    </message>
    <message>
        <source>an untouched image taken with this sensor&apos;s camera</source>
        <translation>用此传感器的相机拍摄的未触碰图像</translation>
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
        <source>The {} was taken with changing settings of camera or light: {}. Lock them, and record it again.</source>
        <translation>{}的拍摄过程中相机或灯光设置有变化：{}。请锁定设置后重新录制。</translation>
    </message>
    <message>
        <source>The {} and the {} were taken with different settings: {}. Depth comes from comparing their brightness: record one of them again.</source>
        <translation>{}与{}的拍摄设置不同：{}。深度来自两者亮度的比较：请重新录制其中之一。</translation>
    </message>
    <message>
        <source>The finger was calibrated with other settings: {}. Restore them, or calibrate again.</source>
        <translation>手指是在不同的设置下标定的：{}。请恢复当时的设置，或重新标定。</translation>
    </message>
    <message>
        <source>the brightness of the untouched face changes from press to press (standard deviation {:.1f} %): exposure or gain is automatic, or the room&apos;s light gets in; lock them, shade the finger and press again</source>
        <translation>接触面未触碰处的亮度随每次按压而变（标准差 {} %）：曝光或增益为自动，或有环境光进入；请锁定它们，给手指遮光后重新按压</translation>
    </message>
    <message>
        <source>the untouched face is {:.1f} % {} in all presses than in the reference: light, exposure or gain has changed in between; the depth is corrected for smooth changes, but let the lamps warm up and record the reference again</source>
        <translation>所有按压中接触面未触碰处都比参考{1} {0} %：其间光照、曝光或增益有变；深度已对平缓的变化作了校正，但请让灯预热后重新录制参考</translation>
    </message>
    <message>
        <source>in {} of {} presses the finger has a bend that the reference recording does not contain, or it has moved in its mount since: record a reference that bends as far, or press with less bending</source>
        <translation>{1} 次按压中有 {0} 次手指的弯曲未包含在参考录像中，或其后手指在安装座中移动了：请录制弯曲同样大的参考，或按压时少弯曲</translation>
    </message>
    <message>
        <source>no mapping resulted</source>
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
        <source>results and ground truth differ in size</source>
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
        <source>this recording no longer exists</source>
        <translation>这段录像已不存在</translation>
    </message>
    <message>
        <source>plugging in its disk, or opening another one</source>
        <translation>插上存放它的磁盘，或打开另一段录像</translation>
    </message>
    <message>
        <source>there is no face to save</source>
        <translation>没有可保存的接触面</translation>
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
        <translation>无法打印报告</translation>
    </message>
    <message>
        <source>this computer cannot draw in 3D: there is no EGL with OpenGL 3.2</source>
        <translation>本机无法显示三维图：没有支持 OpenGL 3.2 的 EGL</translation>
    </message>
    <message>
        <source>installing libegl1 and libgl1-mesa-dri, which render in software</source>
        <translation>安装 libegl1 和 libgl1-mesa-dri，它们用软件渲染</translation>
    </message>
    <message>
        <source>this is not a session of this program</source>
        <translation>这不是本程序的会话</translation>
    </message>
    <message>
        <source>starting a new one</source>
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
        <source>room light adds to the light of the lamps</source>
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
        <source>parts of the image would have no light</source>
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
        <source>an orthographic camera has no focal length for blur</source>
        <translation>正交相机没有用于计算模糊的焦距</translation>
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
        <source>the bubble needs a layer</source>
        <translation>气泡需要有层</translation>
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
        <source>only the lit view face and side faces light each other</source>
        <translation>只有被照亮的视面和侧面互相照亮</translation>
    </message>
    <message>
        <source>name the effects sides and leds too</source>
        <translation>也请写出效果 sides 和 leds</translation>
    </message>
    <message>
        <source>The silicone absorbs part of the light</source>
        <translation>硅胶吸收一部分光</translation>
    </message>
    <message>
        <source>Room light falls on the faces</source>
        <translation>环境光照在各表面上</translation>
    </message>
    <message>
        <source>The camera adapts its exposure to the image brightness</source>
        <translation>相机按图像亮度自动曝光</translation>
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
        <source>Objects outside the focus distance are blurred</source>
        <translation>不在对焦距离上的部分变得模糊</translation>
    </message>
    <message>
        <source>Every pixel is always a little brighter or darker than its neighbours</source>
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
        <source>The camera&apos;s grey levels follow a power law</source>
        <translation>相机的灰度遵循幂律</translation>
    </message>
    <message>
        <source>The face reflects a lamp</source>
        <translation>灯在表面上形成反光</translation>
    </message>
    <message>
        <source>Light comes through a hole in the coat</source>
        <translation>光从涂层的孔中透过</translation>
    </message>
    <message>
        <source>Stray light falls on the sensor</source>
        <translation>杂散光落在传感器上</translation>
    </message>
    <message>
        <source>The finger moves during the exposure</source>
        <translation>曝光期间手指在运动</translation>
    </message>
    <message>
        <source>The rows of an image are exposed one after the other</source>
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
        <source>A speck of dirt is on the face</source>
        <translation>表面上有一个污点</translation>
    </message>
    <message>
        <source>The layer is not equally thick everywhere</source>
        <translation>层的厚度不均匀</translation>
    </message>
    <message>
        <source>Part of the light spreads over the entire image</source>
        <translation>部分光散布到整幅图像</translation>
    </message>
    <message>
        <source>The image is darker towards its corners</source>
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
        <source>a point of the mesh is not a number</source>
        <translation>网格中有一个点不是有效数值</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>重新导出</translation>
    </message>
    <message>
        <source>the mesh does not exist</source>
        <translation>网格不存在</translation>
    </message>
    <message>
        <source>an STL or OBJ file</source>
        <translation>STL 或 OBJ 文件</translation>
    </message>
    <message>
        <source>this mesh format is unknown</source>
        <translation>未知的网格格式</translation>
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
        <source>export a coarser mesh</source>
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
        <source>marker network {}</source>
        <translation>标记点网络 {}</translation>
    </message>
    <message>
        <source>which untouched image a frame is compared with: the one of the finger at rest, the nearest recorded one, or one computed from several near ones</source>
        <translation>一帧与哪张未触碰的图像比较：手指静止时的图像、最近的录制图像，或由最近几张算出的图像</translation>
    </message>
    <message>
        <source>The finger&apos;s body deforms under load</source>
        <translation>手指主体受力变形</translation>
    </message>
    <message>
        <source>a flat sensor has no body that deforms</source>
        <translation>平面传感器没有会变形的主体</translation>
    </message>
    <message>
        <source>leave body out</source>
        <translation>去掉 body</translation>
    </message>
    <message>
        <source>nothing pushes, so no body deforms</source>
        <translation>没有推力，因此主体不会变形</translation>
    </message>
    <message>
        <source>name push too</source>
        <translation>同时写上 push</translation>
    </message>
    <message>
        <source>A cylinder is pressed in sideways</source>
        <translation>一个平放的圆柱压入接触面</translation>
    </message>
    <message>
        <source>sd_px instead of focus_mm and aperture_mm</source>
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
        <source>the body would be {:g} mm in size</source>
        <translation>物体的尺寸会是 {:g} mm</translation>
    </message>
    <message>
        <source>&apos;scale&apos; specifies the mm per unit of the file</source>
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
        <source>a window does not bend parallel rays</source>
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
        <source>the force is 0</source>
        <translation>推力为 0</translation>
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
        <source>a body with creep or damping still moves after a push ends</source>
        <translation>会蠕变或有阻尼的主体仍受已结束的推力影响</translation>
    </message>
    <message>
        <source>instead of &apos;until&apos;, a force_N that goes to 0</source>
        <translation>不用 &apos;until&apos;，而让 force_N 降到 0</translation>
    </message>
    <message>
        <source>the drag is 0</source>
        <translation>切向拉力为 0</translation>
    </message>
    <message>
        <source>another force, or leave it out</source>
        <translation>换一个力，或去掉它</translation>
    </message>
    <message>
        <source>without its body the finger deforms on its contact face only</source>
        <translation>没有主体时，手指只在接触面上变形</translation>
    </message>
    <message>
        <source>name the effect body too</source>
        <translation>同时写上效果 body</translation>
    </message>
    <message>
        <source>the push bends the finger beyond the model&apos;s range</source>
        <translation>推力使手指的弯曲超出模型范围</translation>
    </message>
    <message>
        <source>up to {:.2g} times these forces, or a stiffer body</source>
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
        <translation>标记点 {} 列出了两次</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>每个编号一次</translation>
    </message>
    <message>
        <source>a layer cannot have a modulus or a length of {:g}</source>
        <translation>层的弹性模量或长度不可能是 {:g}</translation>
    </message>
    <message>
        <source>numbers above 0</source>
        <translation>大于 0 的数</translation>
    </message>
    <message>
        <source>{:g} N press the ball into the layer beyond the known range</source>
        <translation>{:g} N 把球压入层的深度超出已知范围</translation>
    </message>
    <message>
        <source>up to {:.3g} N, a larger ball or a harder layer</source>
        <translation>不超过 {:.3g} N，或使用更大的球或更硬的层</translation>
    </message>
    <message>
        <source>a body cannot have a modulus or a length of {:g}</source>
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
        <source>a coupling of {:g} is not a fraction</source>
        <translation>耦合 {:g} 不是一个比例</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 到 1</translation>
    </message>
    <message>
        <source>{:g} cannot be a contact&apos;s modulus, radius, force or friction</source>
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
        <source>{:g} N press the ball into the body beyond the known range</source>
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
        <source>a lens does not change over time</source>
        <translation>镜头不随时间变化</translation>
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
        <source>there is no image of a press</source>
        <translation>没有按压图像</translation>
    </message>
    <message>
        <source>images of a ball of known radius pressed into the face</source>
        <translation>半径已知的球压入接触面的图像</translation>
    </message>
    <message>
        <source>noise is estimated from {} untouched images</source>
        <translation>噪声由 {} 张未触碰的图像估计</translation>
    </message>
    <message>
        <source>temporal noise is estimated from one untouched image and {} outside its contact</source>
        <translation>时间噪声由一张未触碰的图像和 {} 中接触以外的部分估计</translation>
    </message>
    <message>
        <source>{}: too little around the contact can be compared</source>
        <translation>{}：接触周围可比较的部分太少</translation>
    </message>
    <message>
        <source>a press further from the face&apos;s edges</source>
        <translation>离接触面边缘更远的按压</translation>
    </message>
    <message>
        <source>fitting the presses</source>
        <translation>正在拟合按压</translation>
    </message>
    <message>
        <source>not observable: at its limit, or another number has the same effect</source>
        <translation>无法确定：处于范围的端点，或另一个参数有同样的作用</translation>
    </message>
    <message>
        <source>hardly observable in these images</source>
        <translation>由这些图像难以确定</translation>
    </message>
    <message>
        <source>scattering of the layer, per mm</source>
        <translation>层的散射，每 mm</translation>
    </message>
    <message>
        <source>reflection of the coat below the layer</source>
        <translation>层下涂层的反射</translation>
    </message>
    <message>
        <source>the coat below the layer is assumed to be black: the presses show nothing else</source>
        <translation>假定层下涂层为黑色：按压没有显示相反的情况</translation>
    </message>
    <message>
        <source>absorption in the layer is not observable: scattering and coat change the same curve</source>
        <translation>层内的吸收无法确定：散射和涂层改变的是同一条曲线</translation>
    </message>
    <message>
        <source>roll-off length, mm</source>
        <translation>过渡长度，mm</translation>
    </message>
    <message>
        <source>no swelling is visible around the contacts</source>
        <translation>接触周围看不到隆起</translation>
    </message>
    <message>
        <source>height of the swelling, fraction of the layer</source>
        <translation>隆起的高度，占层厚的比例</translation>
    </message>
    <message>
        <source>its distance from the rim, mm</source>
        <translation>隆起到接触边缘的距离，mm</translation>
    </message>
    <message>
        <source>steepness of its slope</source>
        <translation>隆起下降的陡度</translation>
    </message>
    <message>
        <source>blur, standard deviation in pixels</source>
        <translation>模糊，标准差，单位像素</translation>
    </message>
    <message>
        <source>no blur is visible apart from the roll-off</source>
        <translation>除过渡之外看不到模糊</translation>
    </message>
    <message>
        <source>{}: depth, mm</source>
        <translation>{}：深度，mm</translation>
    </message>
    <message>
        <source>{}: position along the face, mm</source>
        <translation>{}：沿接触面的位置，mm</translation>
    </message>
    <message>
        <source>{}: position across the face, mm</source>
        <translation>{}：接触面上的横向位置，mm</translation>
    </message>
    <message>
        <source>{}: light, relative to its untouched image</source>
        <translation>{}：光照，相对于其未触碰的图像</translation>
    </message>
    <message>
        <source>lamp {}: power</source>
        <translation>灯 {}：功率</translation>
    </message>
    <message>
        <source>lamp {}: distance from the face, mm</source>
        <translation>灯 {}：到接触面的距离，mm</translation>
    </message>
    <message>
        <source>lamp {}: distance from the camera, mm</source>
        <translation>灯 {}：到相机的距离，mm</translation>
    </message>
    <message>
        <source>the lamps reproduce the light on the face, not the positions of the real ones: {} of {} positions are not observable</source>
        <translation>这些灯再现接触面上的光照，不一定在真实灯的位置：有 {} 个位置（共 {} 个）无法确定</translation>
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
        <source>shot noise and read noise cannot be separated: the face is too evenly lit, or shot noise is absent</source>
        <translation>散粒噪声与读出噪声无法区分：接触面的光照太均匀，或没有散粒噪声</translation>
    </message>
    <message>
        <source>fixed pattern, fraction</source>
        <translation>固定图案，比例</translation>
    </message>
    <message>
        <source>the scene contains the face only: no side faces, no dots, no twist</source>
        <translation>场景只含接触面：没有侧面、标记点和扭转</translation>
    </message>
    <message>
        <source>there is no untouched image of this finger to compare with</source>
        <translation>没有可供比较的此手指未触碰时的图像</translation>
    </message>
    <message>
        <source>--reference with an image in which nothing touches it</source>
        <translation>用 --reference 给出没有东西触碰它的图像</translation>
    </message>
    <message>
        <source>an image of this finger, at the size of its camera</source>
        <translation>此手指的图像，尺寸与其相机相同</translation>
    </message>
    <message>
        <source>the radius of the ball that was pressed is not known</source>
        <translation>压入球的半径未知</translation>
    </message>
    <message>
        <source>--ball-radius-mm with the radius of the ball</source>
        <translation>用 --ball-radius-mm 给出球的半径</translation>
    </message>
    <message>
        <source>no press was specified, and the finger has none</source>
        <translation>没有指定按压，手指中也没有</translation>
    </message>
    <message>
        <source>images of a ball of known radius pressed into its face</source>
        <translation>半径已知的球压入其接触面的图像</translation>
    </message>
    <message>
        <source>too little of the untouched face is visible</source>
        <translation>接触面未触碰的可见部分太少</translation>
    </message>
    <message>
        <source>images in which the entire face is visible</source>
        <translation>整个接触面可见的图像</translation>
    </message>
    <message>
        <source>no lamp would light the face</source>
        <translation>没有灯会照亮接触面</translation>
    </message>
    <message>
        <source>checking the finger&apos;s face</source>
        <translation>检查手指的接触面</translation>
    </message>
    <message>
        <source>finding the lamps</source>
        <translation>正在寻找灯</translation>
    </message>
    <message>
        <source>no lamp reproduces the untouched image</source>
        <translation>没有灯能近似再现未触碰的图像</translation>
    </message>
    <message>
        <source>noise is estimated from single images: fixed pattern and temporal noise of the camera cannot be separated</source>
        <translation>噪声由单张图像估计：相机的固定图案与时间噪声无法区分</translation>
    </message>
    <message>
        <source>too little of the finger&apos;s length is visible</source>
        <translation>可见的手指长度太短</translation>
    </message>
    <message>
        <source>the finger&apos;s base is on the right of the image, which no scene supports</source>
        <translation>手指的根部在图像右侧，任何场景都不支持</translation>
    </message>
    <message>
        <source>camera.orientation: flip_u in finger.yaml</source>
        <translation>在 finger.yaml 中写上 camera.orientation: flip_u</translation>
    </message>
    <message>
        <source>no scene was found with images close to these</source>
        <translation>没有找到图像与这些接近的场景</translation>
    </message>
    <message>
        <source>images of one ball, pressed in where the entire contact is visible</source>
        <translation>同一个球的图像，压在整个接触可见的位置</translation>
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
        <source>the force model belongs to another reference: its markers rested up to {:.1f} px off the present positions</source>
        <translation>力模型属于另一个参考：其标记点的静止位置与现在的相差达 {:.1f} px</translation>
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
        <source>is not a number</source>
        <translation>不是数</translation>
    </message>
    <message>
        <source>is not a valid number</source>
        <translation>不是有效的数</translation>
    </message>
    <message>
        <source>is not an integer</source>
        <translation>不是整数</translation>
    </message>
    <message>
        <source>is not a list</source>
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
        <source>must be two positions</source>
        <translation>必须是两个位置</translation>
    </message>
    <message>
        <source>must be mean, ridge, quadratic or network</source>
        <translation>必须是 mean、ridge、quadratic 或 network</translation>
    </message>
    <message>
        <source>contains non-text values</source>
        <translation>含有不是文本的内容</translation>
    </message>
    <message>
        <source>does not have the shape that the model needs</source>
        <translation>形状与模型其余部分不符</translation>
    </message>
    <message>
        <source>must be above 0</source>
        <translation>必须大于 0</translation>
    </message>
    <message>
        <source>is not a valid range</source>
        <translation>不是有效的范围</translation>
    </message>
    <message>
        <source>contains non-numeric values</source>
        <translation>含有非数值的内容</translation>
    </message>
    <message>
        <source>must be 2 or 3</source>
        <translation>必须是 2 或 3</translation>
    </message>
    <message>
        <source>must be an integer from 1 to 1024</source>
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
        <source>is not a force model: damaged or truncated</source>
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
        <source>the error of a motor position, with the screw&apos;s play</source>
        <translation>电机位置的误差，包括丝杠的间隙</translation>
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
        <source>must specify the camera&apos;s pose exactly once</source>
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
        <source>the name on the gripper</source>
        <translation>夹爪上写的名称</translation>
    </message>
    <message>
        <source>is also the name of the other finger</source>
        <translation>与另一个手指的名称相同</translation>
    </message>
    <message>
        <source>two names, for example left and right</source>
        <translation>两个不同的名称，例如 left 和 right</translation>
    </message>
    <message>
        <source>does not specify the camera&apos;s pose in the gripper</source>
        <translation>没有给出相机在夹爪中的位置</translation>
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
        <source>the camera pose of finger {} is unknown</source>
        <translation>手指 {} 的相机安装位置未知</translation>
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
        <source>the motor position is not a number</source>
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
        <source>for example 123456789,4.25</source>
        <translation>例如 123456789,4.25</translation>
    </message>
    <message>
        <source>the time is not after that of the line before</source>
        <translation>时间不晚于上一行的时间</translation>
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
        <source>&apos;{}&apos; is not a covariance</source>
        <translation>&apos;{}&apos; 不是协方差</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be 0 or above</source>
        <translation>&apos;{}&apos; 必须大于或等于 0</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>不是 JSON 对象</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be text</source>
        <translation>&apos;{}&apos; 必须是文本</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be an integer</source>
        <translation>&apos;{}&apos; 必须是整数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list</source>
        <translation>&apos;{}&apos; 必须是列表</translation>
    </message>
    <message>
        <source>a region is not a JSON object</source>
        <translation>有一个区域不是 JSON 对象</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must ascend</source>
        <translation>&apos;{}&apos; 必须按升序排列</translation>
    </message>
    <message>
        <source>is not JSON: {}</source>
        <translation>不是 JSON：{}</translation>
    </message>
    <message>
        <source>results.jsonl as alltact reconstruct wrote it</source>
        <translation>使用 alltact reconstruct 写出的 results.jsonl</translation>
    </message>
    <message>
        <source>no marker is visible to estimate the force</source>
        <translation>看不到可用于估计力的标记点</translation>
    </message>
    <message>
        <source>the force model was not trained with frames like this one: its force is unreliable; add rows with such forces to the table and train it again</source>
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
        <source>alltact reconstruct, which reports why</source>
        <translation>运行 alltact reconstruct，它会报告原因</translation>
    </message>
    <message>
        <source>The gauge and the camera used different clocks: their starts are assumed to coincide.</source>
        <translation>测力计和相机使用不同的时钟：假定两者同时开始。</translation>
    </message>
    <message>
        <source>the recording&apos;s frames have no times, the gauge has only times</source>
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
        <source>there are numbers where the names of the columns are expected</source>
        <translation>应为列名之处是数字</translation>
    </message>
    <message>
        <source>the columns &apos;{}&apos; and &apos;{}&apos; both fit {}: rename one of them</source>
        <translation>列“{}”和“{}”都符合 {}：请重命名其中一列</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a unit of the column &apos;{}&apos;: use one of {}</source>
        <translation>“{}”不是列“{}”的单位：请使用 {} 之一</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is in {} here, in {} by its name</source>
        <translation>列“{}”在此处的单位是 {}，其名称中是 {}</translation>
    </message>
    <message>
        <source>a quotation mark is not closed</source>
        <translation>引号没有闭合</translation>
    </message>
    <message>
        <source>there is text behind a closing quotation mark</source>
        <translation>右引号之后还有文字</translation>
    </message>
    <message>
        <source>the file ends in the middle of this line</source>
        <translation>文件在这一行中间结束</translation>
    </message>
    <message>
        <source>copying the file again, or a line end if this line is complete</source>
        <translation>重新复制文件；如果这一行完整，请加上换行符</translation>
    </message>
    <message>
        <source>decimal points, or semicolons between the cells</source>
        <translation>使用小数点，或用分号分隔单元格</translation>
    </message>
    <message>
        <source>The last line of {} (line {}) has no line end: check that the file is complete.</source>
        <translation>{} 的最后一行（第 {} 行）没有换行符：请检查文件是否完整。</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has another decimal mark than the other numbers</source>
        <translation>“{}”的小数点符号与其他数字不同</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not an integer in ns: name the column by its unit, as t_ms</source>
        <translation>“{}”不是以 ns 为单位的整数：请在列名中写明单位，例如 t_ms</translation>
    </message>
    <message>
        <source>&apos;{}&apos; can have the day or the month first: write the year first, as in 2026-12-31</source>
        <translation>“{}”可能是日在前，也可能是月在前：请把年写在最前，例如 2026-12-31</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a time of another form than those before it</source>
        <translation>时间“{}”的格式与之前的不同</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; is missing; found: {}</source>
        <translation>缺少列“{}”；找到的列：{}</translation>
    </message>
    <message>
        <source>semicolon-separated</source>
        <translation>以分号分隔</translation>
    </message>
    <message>
        <source>tab-separated</source>
        <translation>以制表符分隔</translation>
    </message>
    <message>
        <source>comma-separated</source>
        <translation>以逗号分隔</translation>
    </message>
    <message>
        <source>blank-separated</source>
        <translation>以空格分隔</translation>
    </message>
    <message>
        <source>separated by &apos;{}&apos;</source>
        <translation>以“{}”分隔</translation>
    </message>
    <message>
        <source>{} with decimal commas</source>
        <translation>{}，小数点为逗号</translation>
    </message>
    <message>
        <source>{} from the time stamps of &apos;{}&apos;</source>
        <translation>{} 取自“{}”的时间戳</translation>
    </message>
    <message>
        <source>{} from &apos;{}&apos; in {} since 1970</source>
        <translation>{} 取自“{}”，单位 {}，自 1970 年起</translation>
    </message>
    <message>
        <source>{} from &apos;{}&apos; in {}</source>
        <translation>{} 取自“{}”，单位 {}</translation>
    </message>
    <message>
        <source>{} from &apos;{}&apos;</source>
        <translation>{} 取自“{}”</translation>
    </message>
    <message>
        <source>Read {} as {}: {}.</source>
        <translation>已读取 {}，{}：{}。</translation>
    </message>
    <message>
        <source>this is a workbook of a spreadsheet program, not a text</source>
        <translation>这是电子表格程序的工作簿，不是文本</translation>
    </message>
    <message>
        <source>this is a PDF, not a text</source>
        <translation>这是 PDF，不是文本</translation>
    </message>
    <message>
        <source>saving the table as CSV</source>
        <translation>将表格另存为 CSV</translation>
    </message>
    <message>
        <source>the file ends in the middle of a character: it is not complete</source>
        <translation>文件在一个字符中间结束：文件不完整</translation>
    </message>
    <message>
        <source>holds a zero byte: this is no text, or was not written to its end</source>
        <translation>包含零字节：这不是文本，或者没有写完</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a date or time that exists</source>
        <translation>“{}”不是有效的日期或时间</translation>
    </message>
    <message>
        <source>&apos;{}&apos; can be hours and minutes, or minutes and seconds</source>
        <translation>“{}”可能是时和分，也可能是分和秒</translation>
    </message>
    <message>
        <source>a table of motor positions by time, with time_ns and turns</source>
        <translation>电机位置随时间变化的表格，含 time_ns 和 turns</translation>
    </message>
    <message>
        <source>the gauge&apos;s times run from {:g} to {:g} s, those of the images from {:g} to {:g} s</source>
        <translation>测力计的时间从 {} 到 {} s，图像的时间从 {} 到 {} s</translation>
    </message>
    <message>
        <source>{}: the unit is wrong by a factor of {:g}</source>
        <translation>{}：单位相差 {} 倍</translation>
    </message>
    <message>
        <source>naming the column &apos;{}&apos; &apos;t_{}&apos; if its times are in {}</source>
        <translation>如果列“{}”的时间单位如此，请将其命名为“t_{}”（单位 {}）</translation>
    </message>
    <message>
        <source>no frame has a reading: the gauge&apos;s file names &apos;{}&apos;, the recording &apos;{}&apos;</source>
        <translation>没有一帧有读数：测力计文件中的名称是“{}”，录像中是“{}”</translation>
    </message>
    <message>
        <source>the names of the images in the column &apos;frame&apos;</source>
        <translation>在“frame”列中使用图像的名称</translation>
    </message>
    <message>
        <source>no frame has a reading: the readings are {:.3g} s apart, at most {} s can be interpolated</source>
        <translation>没有一帧有读数：读数间隔为 {} s，最多可插值 {} s</translation>
    </message>
    <message>
        <source>a higher rate of the gauge</source>
        <translation>提高测力计的采样率</translation>
    </message>
    <message>
        <source>no frame has a reading: the gauge&apos;s times run from {:g} to {:g} s, those of the images on its clock from {:g} to {:g} s</source>
        <translation>没有一帧有读数：测力计的时间从 {} 到 {} s，图像换算到其时钟为从 {} 到 {} s</translation>
    </message>
    <message>
        <source>a gauge that records with the camera, or --gauge-shift-s</source>
        <translation>让测力计与相机同时记录，或使用 --gauge-shift-s</translation>
    </message>
    <message>
        <source>a table whose head names t_s (or frame), and fx_n and fy_n or force_n</source>
        <translation>表头含 t_s（或 frame）以及 fx_n 和 fy_n 或 force_n 的表格</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is neither 1 nor 0</source>
        <translation>“{}”既不是 1 也不是 0</translation>
    </message>
    <message>
        <source>the time &apos;{}&apos; is that of line {}, too</source>
        <translation>时间“{}”与第 {} 行相同</translation>
    </message>
    <message>
        <source>the time &apos;{}&apos; comes after &apos;{}&apos; of line {}, which is later</source>
        <translation>时间“{}”出现在更晚的“{}”（第 {} 行）之后</translation>
    </message>
    <message>
        <source>the name of the frame is missing</source>
        <translation>缺少帧的名称</translation>
    </message>
    <message>
        <source>the frame &apos;{}&apos; is that of line {}, too</source>
        <translation>帧“{}”与第 {} 行相同</translation>
    </message>
    <message>
        <source>a table whose head names u0, v0, ..., fx_n, fy_n; alltact force --collect makes one</source>
        <translation>表头含 u0、v0、…、fx_n、fy_n 的表格；alltact force --collect 可生成</translation>
    </message>
    <message>
        <source>the gauge&apos;s file holds no reading</source>
        <translation>测力计文件中没有读数</translation>
    </message>
    <message>
        <source>the column &apos;{}&apos; appears twice</source>
        <translation>列 &apos;{}&apos; 出现两次</translation>
    </message>
    <message>
        <source>the contact position has only one of along_mm and across_mm</source>
        <translation>接触位置只给出了 along_mm 和 across_mm 中的一个</translation>
    </message>
    <message>
        <source>has {} cells, not {}</source>
        <translation>有 {} 个单元格，而不是 {} 个</translation>
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
        <source>contains no contact force</source>
        <translation>不含任何接触力</translation>
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
        <source>--split block, or several values</source>
        <translation>使用 --split block，或使用该列有多个不同值的表</translation>
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
        <source>removing the line, or entering what was measured</source>
        <translation>删除此行，或填入测得的值</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is beyond the measurable range</source>
        <translation>&apos;{}&apos; 超出可测范围</translation>
    </message>
    <message>
        <source>no marker was seen</source>
        <translation>没有看到标记点</translation>
    </message>
    <message>
        <source>{} rows are too few to train with</source>
        <translation>{} 行太少，无法训练</translation>
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
        <source>the finger has no markers to estimate a force from</source>
        <translation>手指没有标记点，无法由其估计力</translation>
    </message>
    <message>
        <source>a finger with markers</source>
        <translation>有标记点的手指</translation>
    </message>
    <message>
        <source>the finger has no reference, so the rest positions of its markers are unknown</source>
        <translation>手指没有参考，因此其标记点的静止位置未知</translation>
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
        <source>the table&apos;s markers belong to another finger: in every row they are {:.0f} px or more from this finger&apos;s rest positions</source>
        <translation>表中的标记点属于另一个手指：在每一行中，它们与此手指标记点静止位置的距离都不小于 {:.0f} px</translation>
    </message>
    <message>
        <source>there is no force model to revert</source>
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
        <source>the force model does not name its table</source>
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
        <source>training {}, leaving out one block at a time</source>
        <translation>正在训练{}，每次留出一个数据块</translation>
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
        <source>The chosen model does not beat the table&apos;s mean: these markers do not show the force.</source>
        <translation>选用的模型不优于表的平均值：由这些标记点无法得出力。</translation>
    </message>
    <message>
        <source>Nothing beats the mean of the table: these markers do not show the force.</source>
        <translation>没有比表的平均值更好的模型：由这些标记点无法得出力。</translation>
    </message>
    <message>
        <source>The table has no column &apos;block&apos;: {} sections of consecutive rows were held out.</source>
        <translation>表中没有列 &apos;block&apos;：留出了 {} 段连续的行。</translation>
    </message>
    <message>
        <source>Only {} groups could be held out: errors and intervals are rough.</source>
        <translation>只能留出 {} 组：误差和区间较粗略。</translation>
    </message>
    <message>
        <source>without a depth there is no position on the contact face</source>
        <translation>没有深度就没有接触面上的位置</translation>
    </message>
    <message>
        <source>stopped before the experiments ended</source>
        <translation>实验结束之前已停止</translation>
    </message>
    <message>
        <source>{}: frame {} of {}</source>
        <translation>{}：第 {} 帧，共 {} 帧</translation>
    </message>
    <message>
        <source>no frame gives a value for the experiment</source>
        <translation>没有任何一帧给出该实验所需的值</translation>
    </message>
    <message>
        <source>contact position, at 9 x 3 points of the face</source>
        <translation>接触面 9 x 3 个点上的接触位置</translation>
    </message>
    <message>
        <source>rotation of a held bar</source>
        <translation>被夹持的杆的转角</translation>
    </message>
    <message>
        <source>smallest detectable depth of a ball</source>
        <translation>可检测的最小压球深度</translation>
    </message>
    <message>
        <source>smallest detectable force on every face</source>
        <translation>每个面上可检测的最小力</translation>
    </message>
    <message>
        <source>push direction, one of 8 sides</source>
        <translation>推压方向，8 个方向之一</translation>
    </message>
    <message>
        <source>one untouched image against a recording of all poses</source>
        <translation>一张未触碰的图像与全部姿态录像的比较</translation>
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
        <source>time for each step of a frame, full HD with 24 dots</source>
        <translation>全高清、24 个点时每帧各步骤的时间</translation>
    </message>
    <message>
        <source>there is no experiment &apos;{}&apos;</source>
        <translation>没有实验 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>smallest force detected on the contact face, all heights</source>
        <translation>接触面上可检测的最小力，全部高度</translation>
    </message>
    <message>
        <source>smallest force detected on the back, all heights</source>
        <translation>背面可检测的最小力，全部高度</translation>
    </message>
    <message>
        <source>smallest force detected on the upper side, all heights</source>
        <translation>上侧面可检测的最小力，全部高度</translation>
    </message>
    <message>
        <source>smallest force detected on the lower side, all heights</source>
        <translation>下侧面可检测的最小力，全部高度</translation>
    </message>
    <message>
        <source>smallest depth detected, {:.0f} mm from the base</source>
        <translation>距根部 {:.0f} mm 处可检测的最小深度</translation>
    </message>
    <message>
        <source>Depths double from 0.01 mm on, so that the smallest is between a value and its half</source>
        <translation>深度从 0.01 mm 起逐次加倍，因此最小值在所给数字与其一半之间</translation>
    </message>
    <message>
        <source>All heights are beyond {:.0f} mm, where the paper reports less than 2 N; the body in the scene is rubber of Shore 40 A, the paper&apos;s silicone differs</source>
        <translation>所有高度都超过 {:.0f} mm，论文在那里给出的值不到 2 N；场景中的手指主体是 Shore 40 A 橡胶，论文的硅胶不同</translation>
    </message>
    <message>
        <source>pushes with the correct side of 8</source>
        <translation>在 8 个方向中判断正确的推压</translation>
    </message>
    <message>
        <source>direction of a push in the image, mean error</source>
        <translation>图像中推压方向的平均误差</translation>
    </message>
    <message>
        <source>direction of a push in the image, maximum error</source>
        <translation>图像中推压方向的最大误差</translation>
    </message>
    <message>
        <source>{} pushes, by the true motion of the dots in the image; those near a border of two sides count like all others</source>
        <translation>{} 次推压，以点在图像中的真实运动为准；靠近两个方向边界的与其他的一样计入</translation>
    </message>
    <message>
        <source>frames under 40 px, nearest recorded image</source>
        <translation>低于 40 px 的帧，录像中最近的一帧</translation>
    </message>
    <message>
        <source>frames under 40 px, one reference</source>
        <translation>低于 40 px 的帧，单一参考</translation>
    </message>
    <message>
        <source>depth without contact, one reference</source>
        <translation>无接触处的深度，单一参考</translation>
    </message>
    <message>
        <source>depth without contact, nearest recorded image</source>
        <translation>无接触处的深度，录像中最近的一帧</translation>
    </message>
    <message>
        <source>depth without contact, local regression</source>
        <translation>无接触处的深度，局部回归</translation>
    </message>
    <message>
        <source>The number of frames near a single reference depends on how far the finger moves; here the scene sets this, in the paper its own recording</source>
        <translation>单一参考附近的帧数取决于手指移动的幅度；此处由场景决定，论文中由其自身的录像决定</translation>
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
        <translation>标记点和参考，中位数</translation>
    </message>
    <message>
        <source>local depth and contacts, median</source>
        <translation>局部深度和接触，中位数</translation>
    </message>
    <message>
        <source>entire frame, median</source>
        <translation>整帧，中位数</translation>
    </message>
    <message>
        <source>Times were measured on this computer, those of the paper on its own; the finger uses the demonstration&apos;s mapping and 24 recorded poses</source>
        <translation>用时在本计算机上测得，论文的用时在其自己的计算机上测得；手指使用演示的映射和 24 个录制的姿态</translation>
    </message>
    <message>
        <source>position, mean error within +-20 mm of the middle</source>
        <translation>位置，中部 +-20 mm 内的平均误差</translation>
    </message>
    <message>
        <source>position, mean error at the tip</source>
        <translation>位置，指尖处的平均误差</translation>
    </message>
    <message>
        <source>position, greatest error</source>
        <translation>位置，最大误差</translation>
    </message>
    <message>
        <source>contacts found</source>
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
        <source>bars whose angle is measured</source>
        <translation>测得角度的杆</translation>
    </message>
    <message>
        <source>The lesser of the paper&apos;s two figures is next to the mean error, the greater one next to the greatest error</source>
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
        <source>an image in which the entire face is brighter than its side faces, or our own method</source>
        <translation>使用整个接触面亮于其侧面的图像，或使用本程序的方法</translation>
    </message>
    <message>
        <source>the binarised image shows both edges of the face in {} of {} columns; at least a fifth is needed</source>
        <translation>二值化图像在 {} 列中显示出接触面的两条边缘（共 {} 列），而至少需要五分之一</translation>
    </message>
    <message>
        <source>the edges of the face give no distance</source>
        <translation>由接触面的边缘无法得出距离</translation>
    </message>
    <message>
        <source>our own method, which needs no dots, or a recording of a finger that has them</source>
        <translation>使用本程序的方法，它不需要标记点，或使用带标记点的手指的录像</translation>
    </message>
    <message>
        <source>alltact reference with a video of the untouched finger bending</source>
        <translation>用未触碰手指的弯曲视频运行 alltact reference</translation>
    </message>
    <message>
        <source>the source paper&apos;s method chooses its reference by the markers, and this finger has none</source>
        <translation>原论文的方法按标记点选择参考，而此手指没有标记点</translation>
    </message>
    <message>
        <source>the source paper&apos;s method sorts two full rows, and {} of this finger&apos;s dots are missing</source>
        <translation>原论文的方法对两排完整的标记点排序，而此手指缺少 {} 个标记点</translation>
    </message>
    <message>
        <source>fewer than two dots of a row are visible; the source paper&apos;s method cannot infer the others: uncover and light the dots on the side faces</source>
        <translation>一排中可见的标记点不足两个，原论文的方法无法推断其余的点：请露出并照亮侧面上的标记点</translation>
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
        <translation>原论文的方法在 {} 帧中都没有找到接触面和标记点</translation>
    </message>
    <message>
        <source>our own method, or a recording with brighter dots</source>
        <translation>使用本程序的方法，或标记点更亮的录像</translation>
    </message>
    <message>
        <source>{} dots were found next to the face: too few to sort into two rows</source>
        <translation>在接触面旁找到 {} 个点：太少，无法排成两排</translation>
    </message>
    <message>
        <source>a network exported with fixed sizes, one image at a time and opset 11 or 12, or --marker-network own</source>
        <translation>使用以固定尺寸、每次一张图像和 opset 11 或 12 导出的神经网络，或使用 --marker-network own</translation>
    </message>
    <message>
        <source>OpenCV cannot run this network</source>
        <translation>OpenCV 无法运行此神经网络</translation>
    </message>
    <message>
        <source>this network outputs {} for {}, which are neither dots nor boxes</source>
        <translation>此神经网络的输出为 {}，输入为 {}，输出既不是点也不是框</translation>
    </message>
    <message>
        <source>this network outputs numbers that are not finite</source>
        <translation>此神经网络输出的数不是有限数</translation>
    </message>
    <message>
        <source>the file with this network&apos;s expected output is missing</source>
        <translation>缺少此神经网络预期输出的文件</translation>
    </message>
    <message>
        <source>training it again, which writes both files</source>
        <translation>重新训练，这会写出两个文件</translation>
    </message>
    <message>
        <source>the image must have the size of the network&apos;s input, {} x {}</source>
        <translation>图像必须与神经网络的输入尺寸相同，即 {} x {}</translation>
    </message>
    <message>
        <source>this network takes {}, not one image of 1 or 3 channels and a fixed size of {} to {} px a side</source>
        <translation>此神经网络接受 {}，而不是一张 1 或 3 通道、边长固定在 {} 到 {} px 之间的图像</translation>
    </message>
    <message>
        <source>OpenCV cannot read this network (opset {}; it supports those up to 12 well)</source>
        <translation>OpenCV 无法读取此神经网络（opset {}；它能很好地支持 12 及以下）</translation>
    </message>
    <message>
        <source>the network and its .yaml of the same training, or exporting it with opset 11 or 12</source>
        <translation>使用同一次训练得到的神经网络及其 .yaml，或以 opset 11 或 12 导出</translation>
    </message>
    <message>
        <source>the network outputs {} numbers where its .yaml has {}</source>
        <translation>神经网络输出 {} 个数，而其 .yaml 中有 {} 个</translation>
    </message>
    <message>
        <source>for a known image the network&apos;s numbers deviate by up to {:.3g} from its .yaml, and {:.3g} is allowed</source>
        <translation>对一张已知图像，神经网络输出的数与其 .yaml 最多相差 {:.3g}，而允许的是 {:.3g}</translation>
    </message>
    <message>
        <source>this is not a network in the ONNX format, or it is incomplete or damaged</source>
        <translation>这不是 ONNX 格式的神经网络，或者不完整，或者已损坏</translation>
    </message>
    <message>
        <source>copying or exporting the file again</source>
        <translation>重新复制或导出该文件</translation>
    </message>
    <message>
        <source>subpixel edges</source>
        <translation>边缘取亚像素</translation>
    </message>
    <message>
        <source>integer-pixel edges</source>
        <translation>边缘取整像素</translation>
    </message>
    <message>
        <source>&apos;crossing&apos; measures the finger&apos;s bend, and so press positions, several times more accurately</source>
        <translation>&apos;crossing&apos; 得出的手指弯曲以及由此得出的按压位置要精确数倍</translation>
    </message>
    <message>
        <source>&apos;crossing&apos; takes a little longer</source>
        <translation>&apos;crossing&apos; 用时稍长</translation>
    </message>
    <message numerus="yes">
        <source>edges from {} columns</source>
        <comment>edges from {} column</comment>
        <translation>
            <numerusform>边缘取自 {} 列</numerusform>
        </translation>
    </message>
    <message>
        <source>more reduce the noise of dark images; beyond 16 a bent finger&apos;s edge is no longer straight within them</source>
        <translation>越多越能抑制暗图像的噪声；超过 16 时，弯曲手指的边缘在其中不再是直的</translation>
    </message>
    <message>
        <source>fewer make more positions, to each of which the curve must be fitted</source>
        <translation>越少则位置越多，曲线须对每个位置进行拟合</translation>
    </message>
    <message>
        <source>edge curve of degree {}</source>
        <translation>边缘曲线为 {} 次</translation>
    </message>
    <message>
        <source>higher follows sharper bends; too high follows noise where the edge is hidden</source>
        <translation>越高越能跟随急剧的弯曲；过高则会在边缘被遮住处跟随噪声</translation>
    </message>
    <message>
        <source>higher makes the fit slower</source>
        <translation>越高则拟合用时越长</translation>
    </message>
    <message>
        <source>how the engraved dots are found and numbered: spots tracked by the finger&apos;s motion, the source paper&apos;s two sorted rows, or a convolutional network in every frame</source>
        <translation>如何找到刻出的标记点并编号：按手指的运动跟踪斑点、原论文的两排排序，或在每一帧中使用卷积神经网络</translation>
    </message>
    <message>
        <source>markers tracked as spots</source>
        <translation>标记点按斑点跟踪</translation>
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
        <source>&apos;network&apos; finds more dots that are worn, dark or badly lit; &apos;paper&apos; loses its numbers where dots are hidden</source>
        <translation>&apos;network&apos; 能找到更多磨损、暗淡或光照不良的标记点；&apos;paper&apos; 在标记点被遮住处会丢失编号</translation>
    </message>
    <message>
        <source>&apos;network&apos; takes many times as long</source>
        <translation>&apos;network&apos; 用时是其他方法的许多倍</translation>
    </message>
    <message>
        <source>the network for marker-method network, and for paper where one is named: an ONNX file, also a detector such as YOLO11</source>
        <translation>marker-method network 使用的神经网络，指定时 paper 也使用：一个 ONNX 文件，也可以是 YOLO11 之类的检测器</translation>
    </message>
    <message>
        <source>compared with the image at rest</source>
        <translation>与静止时的图像比较</translation>
    </message>
    <message>
        <source>compared with the nearest image</source>
        <translation>与最接近的图像比较</translation>
    </message>
    <message>
        <source>compared with several images</source>
        <translation>与多张图像比较</translation>
    </message>
    <message>
        <source>&apos;local&apos; measures depth of a bent finger correctly between the recorded poses; &apos;single&apos; only at rest</source>
        <translation>&apos;local&apos; 能正确测量弯曲手指在已录制姿态之间的深度；&apos;single&apos; 只在静止时正确</translation>
    </message>
    <message>
        <source>&apos;local&apos; adds up several images instead of one</source>
        <translation>&apos;local&apos; 要累加多张图像，而不是一张</translation>
    </message>
    <message>
        <source>light corrected</source>
        <translation>光照已校正</translation>
    </message>
    <message>
        <source>light as recorded</source>
        <translation>光照与录像相同</translation>
    </message>
    <message>
        <source>&apos;corrected&apos; corrects depth when the room or the lamp changes</source>
        <translation>&apos;corrected&apos; 在房间或灯光变化时校正深度</translation>
    </message>
    <message>
        <source>&apos;corrected&apos; analyses the untouched skin once</source>
        <translation>&apos;corrected&apos; 要对未触碰的表皮分析一遍</translation>
    </message>
    <message>
        <source>no smoothing</source>
        <translation>不平滑</translation>
    </message>
    <message>
        <source>smoothing of {:g} px</source>
        <translation>平滑 {} px</translation>
    </message>
    <message>
        <source>more reduces the noise of a smooth contact and rounds off edges and threads</source>
        <translation>越多则平滑接触的深度噪声越小，但边缘和螺纹会变圆</translation>
    </message>
    <message>
        <source>more takes longer, none is fastest</source>
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
        <source>&apos;{}&apos; is not a direction</source>
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
        <source>&apos;{}&apos; does not describe a gauge&apos;s report</source>
        <translation>“{}”没有描述测力计的报告</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a valid {}</source>
        <translation>“{}”不能用作 {}</translation>
    </message>
    <message>
        <source>the table does not describe a gauge&apos;s report</source>
        <translation>表格没有描述测力计的报告</translation>
    </message>
    <message>
        <source>The device sends other reports than described. Try: check the id and length.</source>
        <translation>设备发送的报告与所描述的不同。建议：检查 id 和长度。</translation>
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
        <source>&apos;{}&apos; is not a text with \r, \n, \xHH</source>
        <translation>“{}”不是带有 \r、\n、\xHH 的文本</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a unit of force</source>
        <translation>“{}”不是力的单位</translation>
    </message>
    <message>
        <source>N, mN, kN, g, kgf, lbf or ozf</source>
        <translation>N、mN、kN、g、kgf、lbf 或 ozf</translation>
    </message>
    <message>
        <source>the unit of a HID gauge belongs in its report&apos;s description</source>
        <translation>HID 测力计的单位在其报告描述中给出</translation>
    </message>
    <message>
        <source>unit= in the report&apos;s description</source>
        <translation>在报告描述中使用 unit=</translation>
    </message>
    <message>
        <source>model, speed and question apply only to a serial gauge</source>
        <translation>型号、速率和查询命令只用于串口测力计</translation>
    </message>
    <message>
        <source>serial:/dev/ttyUSB0</source>
        <translation>serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>the position of the force in the gauge&apos;s reports is not specified</source>
        <translation>未指定力在测力计报告中的位置</translation>
    </message>
    <message>
        <source>a report is specified for a gauge that is not a HID device</source>
        <translation>为不是 HID 设备的测力计给出了报告描述</translation>
    </message>
    <message>
        <source>hid:DEVICE and &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;</source>
        <translation>hid:DEVICE 和 &apos;id=3 at=1 type=s16 scale=0.01 unit=N&apos;</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a gauge</source>
        <translation>“{}”不是测力计</translation>
    </message>
    <message>
        <source>typed, serial:/dev/ttyUSB0 or hid:DEVICE</source>
        <translation>typed、serial:/dev/ttyUSB0 或 hid:DEVICE</translation>
    </message>
    <message>
        <source>{} lines from the gauge were not readings</source>
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
        <source>this is not a serial line</source>
        <translation>这不是串口</translation>
    </message>
    <message>
        <source>the gauge&apos;s /dev/tty...</source>
        <translation>使用测力计的 /dev/tty...</translation>
    </message>
    <message>
        <source>the serial line does not support {} baud</source>
        <translation>串口不支持 {} 波特</translation>
    </message>
    <message>
        <source>the speed given in the gauge&apos;s manual</source>
        <translation>使用测力计手册中给出的速率</translation>
    </message>
    <message>
        <source>{} baud is not a speed of a serial line</source>
        <translation>{} 波特不是串口的速率</translation>
    </message>
    <message>
        <source>9600, 19200, 115200 or the speed in the gauge&apos;s manual</source>
        <translation>9600、19200、115200，或测力计手册中给出的速率</translation>
    </message>
    <message>
        <source>the serial line cannot be opened</source>
        <translation>无法打开串口</translation>
    </message>
    <message>
        <source>the serial line accepts no data</source>
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
        <source>the typed value no longer applies</source>
        <translation>之前键入的值不再有效</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a reading; type a number, &apos;y 1.2 N&apos;, &apos;block NAME&apos;, or nothing</source>
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
        <source>position and force in rooms of 300, 1100 and 2500 lux</source>
        <translation>300、1100 和 2500 勒克斯的房间中的位置和力</translation>
    </message>
    <message>
        <source>Our values are simulated, with known truth; the paper&apos;s were measured on a real finger.</source>
        <translation>本程序的值为仿真所得，真值已知；论文的值在真实手指上测得。</translation>
    </message>
    <message>
        <source>least detected depth of a ball, ours only</source>
        <translation>能检测到的最小压球深度，仅本程序</translation>
    </message>
    <message>
        <source>position along the finger (mm)</source>
        <translation>沿手指的位置（mm）</translation>
    </message>
    <message>
        <source>least detected depth (mm)</source>
        <translation>能检测到的最小深度（mm）</translation>
    </message>
    <message>
        <source>least detected force on every face, by height</source>
        <translation>每个面上能检测到的最小力随高度的变化</translation>
    </message>
    <message>
        <source>least detected force (N)</source>
        <translation>能检测到的最小力（N）</translation>
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
        <source>position error in rooms of different light; the paper gives no figure by room</source>
        <translation>不同光照的房间中的位置误差；论文没有按房间给出数字</translation>
    </message>
    <message>
        <source>mean position error (mm)</source>
        <translation>位置的平均误差（mm）</translation>
    </message>
    <message>
        <source>force error in rooms of different light, with a model trained in the dark</source>
        <translation>不同光照的房间中力的误差，所用模型在黑暗中训练</translation>
    </message>
    <message>
        <source>mean error of Fx and Fy (N)</source>
        <translation>Fx 和 Fy 的平均误差（N）</translation>
    </message>
    <message>
        <source>position, mean error at {} lux</source>
        <translation>位置，{} 勒克斯时的平均误差</translation>
    </message>
    <message>
        <source>force, mean error at {} lux</source>
        <translation>力，{} 勒克斯时的平均误差</translation>
    </message>
    <message>
        <source>position, greatest change between rooms</source>
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
        <source>The scene assumes how much of a room&apos;s light enters a finger: 4 grey levels of a white surface per 1000 lux; every room shows the same frames</source>
        <translation>进入手指的房间光量由场景假定：每 1000 勒克斯使白色表面增加 4 个灰度级；每个房间使用相同的帧</translation>
    </message>
    <message>
        <source>correct (%)</source>
        <translation>判断正确（%）</translation>
    </message>
    <message>
        <source>one of 8 sides</source>
        <translation>8 个方向</translation>
    </message>
    <message>
        <source>share of frames with a reference closer than the given px, summed over the dots</source>
        <translation>参考距离（各点之和）小于给定 px 数的帧所占比例</translation>
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
        <source>estimated force (N)</source>
        <translation>估计力（N）</translation>
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
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>error along the finger: pushes near the base move the markers least</source>
        <translation>误差沿手指的分布：推压根部附近时标记点移动最少</translation>
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
        <source>Fx, paper, over all positions</source>
        <translation>Fx，论文，全部位置</translation>
    </message>
    <message>
        <source>Fy, paper, over all positions</source>
        <translation>Fy，论文，全部位置</translation>
    </message>
    <message>
        <source>Fx estimated at positions held out</source>
        <translation>在留出位置上估计的 Fx</translation>
    </message>
    <message>
        <source>Fy estimated at positions held out</source>
        <translation>在留出位置上估计的 Fy</translation>
    </message>
    <message>
        <source>Fx, mean error at positions held out</source>
        <translation>Fx，留出位置上的平均误差</translation>
    </message>
    <message>
        <source>Fy, mean error at positions held out</source>
        <translation>Fy，留出位置上的平均误差</translation>
    </message>
    <message>
        <source>Fx, the same for the worst finger</source>
        <translation>Fx，同上，最差的手指</translation>
    </message>
    <message>
        <source>Fy, the same for the worst finger</source>
        <translation>Fy，同上，最差的手指</translation>
    </message>
    <message>
        <source>forces within their 95 % intervals</source>
        <translation>落在其 95 % 区间内的力</translation>
    </message>
    <message>
        <source>the same, deviation from 95 %</source>
        <translation>同上，与 95 % 的偏差</translation>
    </message>
    <message>
        <source>{} fingers drawn at random, 484 pushes each at {} positions, some of which are held out entirely; {} pushes are measured, the others show too few markers. Forces act on the finger, in the camera&apos;s axes, without a gauge&apos;s error</source>
        <translation>随机抽取 {} 个手指，每个在 {} 个位置上推压 484 次，其中部分位置整个留出；测得 {} 次推压，其余推压找到的标记点太少。力为作用在手指上的力，以相机坐标轴表示，不含测力计误差</translation>
    </message>
    <message>
        <source>No drag acts along the finger: it hardly moves a marker, so no marker shows it</source>
        <translation>没有沿手指方向的拉力：它几乎不使标记点移动，也没有标记点能反映它</translation>
    </message>
    <message>
        <source>relief error, ours only: the paper shows only images</source>
        <translation>浮雕误差，仅本程序：论文只给出图像</translation>
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
        <source>entire frame</source>
        <translation>整帧</translation>
    </message>
    <message>
        <source>position error along the finger, one point per contact</source>
        <translation>沿手指的位置误差，每次接触一个点</translation>
    </message>
    <message>
        <source>position error (mm)</source>
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
        <source>angle error of a bar, by its orientation</source>
        <translation>杆的角度误差随其转角的变化</translation>
    </message>
    <message>
        <source>true angle (degrees)</source>
        <translation>真实角度（度）</translation>
    </message>
    <message>
        <source>angle error (degrees)</source>
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
        <source>this is not the file of the finger&apos;s calibration</source>
        <translation>这不是该手指标定的文件</translation>
    </message>
    <message>
        <source>pressing in different directions; several tables may be given</source>
        <translation>向不同方向按压；可以给出多个表</translation>
    </message>
    <message>
        <source>The gauge reports {:.0f} ms (sd {:.0f} ms) later than the images; this is corrected.</source>
        <translation>测力计的读数比图像晚 {:.0f} ms（标准差 {:.0f} ms）；已作校正。</translation>
    </message>
    <message>
        <source>The gauge reports {:.0f} ms (sd {:.0f} ms) earlier than the images; this is corrected.</source>
        <translation>测力计的读数比图像早 {:.0f} ms（标准差 {:.0f} ms）；已作校正。</translation>
    </message>
    <message>
        <source>The gauge&apos;s delay could not be estimated from these frames: nothing is corrected. Try: some quick taps while recording.</source>
        <translation>无法由这些帧得出测力计的延迟：未作任何校正。建议：录制时快速轻触几次。</translation>
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
        <source>pressing the ball in deeper, entirely on the face</source>
        <translation>把球压得更深，并使其完全在接触面上</translation>
    </message>
    <message>
        <source>nothing is dark enough for a pressed ball</source>
        <translation>没有区域暗到足以表明有球压入</translation>
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
        <source>all are excluded</source>
        <translation>所有按压都已排除</translation>
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
        <source>the source paper&apos;s method calibrates differently, and this finger has no stored presses for it</source>
        <translation>原论文的方法以不同方式标定，而此手指没有保存可用的按压</translation>
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
        <source>too few images of the reference recording show the face</source>
        <translation>参考录像中显示接触面的图像太少</translation>
    </message>
    <message>
        <source>record the finger bending through all its poses</source>
        <translation>录制手指弯曲经过其所有姿态的过程</translation>
    </message>
    <message>
        <source>balls painted into untouched images of {}</source>
        <translation>画入 {} 的未触碰图像中的球</translation>
    </message>
    <message>
        <source>the demonstration&apos;s finger, simulated, pressed at random positions</source>
        <translation>演示的手指，仿真，在随机位置按压</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>is not a study file of this program</source>
        <translation>不是本程序的研究文件</translation>
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
        <source>one of its lines is damaged</source>
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
        <source>part {} exists twice: {} and {}</source>
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
        <source>&apos;{}&apos; is not a valid part</source>
        <translation>&apos;{}&apos; 不是有效的部分编号</translation>
    </message>
    <message>
        <source>1/8 to 8/8 for eight parts, for example</source>
        <translation>例如分成八个部分时用 1/8 到 8/8</translation>
    </message>
    <message>
        <source>could not confirm that the files are on the disk</source>
        <translation>无法确认文件已写到磁盘</translation>
    </message>
    <message>
        <source>the image is not marked as depth in 16 bits</source>
        <translation>图像未标明含有 16 位深度</translation>
    </message>
    <message>
        <source>an image from alltact reconstruct --format depth16</source>
        <translation>使用 alltact reconstruct --format depth16 写出的图像</translation>
    </message>
    <message>
        <source>the part of the face to measure depth on, in millimetres along it from its base; all else counts as off the face</source>
        <translation>测量深度的那一段接触面，从根部起沿接触面以毫米计；其余都视为不在接触面上</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not &apos;all&apos; or a part of the face in mm such as 20-60</source>
        <translation>&apos;{}&apos; 既不是 &apos;all&apos;，也不是接触面上以 mm 计的一段，如 20-60</translation>
    </message>
    <message>
        <source>pixels used to measure an image: all of them, or means of 2 by 2 or 4 by 4 of them; results in pixels then refer to that image</source>
        <translation>测量图像所用的像素：全部，或每 2×2 或 4×4 个的平均；以像素计的结果则以该图像为准</translation>
    </message>
    <message>
        <source>every pixel</source>
        <translation>全部像素</translation>
    </message>
    <message>
        <source>half the pixels per side</source>
        <translation>每边一半像素</translation>
    </message>
    <message>
        <source>a quarter of the pixels per side</source>
        <translation>每边四分之一像素</translation>
    </message>
    <message>
        <source>&apos;whole&apos; detects small contacts and steep edges, and numbers small dots</source>
        <translation>&apos;whole&apos; 能识别小的接触和陡的边缘，并能给小的标记点编号</translation>
    </message>
    <message>
        <source>&apos;half&apos; uses a quarter of the pixels and of the recording&apos;s memory, &apos;quarter&apos; a sixteenth</source>
        <translation>&apos;half&apos; 的像素和录像所占内存为四分之一，&apos;quarter&apos; 为十六分之一</translation>
    </message>
    <message>
        <source>images of one source whose running mean is measured; 1: each by itself. A moving finger then appears at its average position, and blurred</source>
        <translation>取滑动平均后再测量的同一来源的图像数；1：逐张测量。运动中的手指则显示在其平均位置上，而且模糊</translation>
    </message>
    <message numerus="yes">
        <source>{} images averaged</source>
        <comment>{} image averaged</comment>
        <translation>
            <numerusform>{} 张图像取平均</numerusform>
        </translation>
    </message>
    <message>
        <source>more reduce the noise of a finger that holds still, by their square root</source>
        <translation>越多，静止手指的噪声越小，按数目的平方根降低</translation>
    </message>
    <message>
        <source>more delay the results, by half their number; adding them up takes a little time</source>
        <translation>越多，手指的结果越滞后，滞后为其数目的一半；累加要花少许时间</translation>
    </message>
    <message>
        <source>depth on the full face</source>
        <translation>整个接触面的深度</translation>
    </message>
    <message>
        <source>depth from {:g} to {:g} mm along the face</source>
        <translation>接触面上 {} 到 {} mm 的深度</translation>
    </message>
    <message>
        <source>&apos;all&apos; misses no contact</source>
        <translation>&apos;all&apos; 不会漏掉任何接触</translation>
    </message>
    <message>
        <source>depth takes less time, in proportion to the part&apos;s length</source>
        <translation>计算深度的用时随该部分的长度按比例减少</translation>
    </message>
    <message>
        <source>recorded images from which reference-method local computes the reference</source>
        <translation>reference-method local 计算参考所用的录制图像数</translation>
    </message>
    <message numerus="yes">
        <source>reference from {} images</source>
        <comment>reference from {} image</comment>
        <translation>
            <numerusform>参考取自 {} 张图像</numerusform>
        </translation>
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
        <source>so few measured pixels, or pixels on one line, define no plane</source>
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
        <source>a round piece, visible down to half its depth</source>
        <translation>使用圆形的区域，且到深度减半处都可见</translation>
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
        <source>the piece is too narrow to remove its form</source>
        <translation>区域太窄，无法扣除其形状</translation>
    </message>
    <message>
        <source>a wider one</source>
        <translation>使用更宽的区域</translation>
    </message>
    <message>
        <source>no step along this line exceeds the noise</source>
        <translation>沿此线没有高出噪声的台阶</translation>
    </message>
    <message>
        <source>a line that crosses the step at a right angle</source>
        <translation>使用与台阶成直角相交的线</translation>
    </message>
    <message>
        <source>part of this piece is at a limit of the measuring range</source>
        <translation>此区域的一部分处于测量极限</translation>
    </message>
    <message>
        <source>a piece that is pressed in less deeply</source>
        <translation>使用压入较浅的区域</translation>
    </message>
    <message>
        <source>one side of the step is too short to be a plane</source>
        <translation>台阶的一侧太短，不足以构成平面</translation>
    </message>
    <message>
        <source>a line that reaches further over both sides</source>
        <translation>使用在两侧都延伸得更远的线</translation>
    </message>
    <message>
        <source>one side of the step is not flat</source>
        <translation>台阶的一侧不是平面</translation>
    </message>
    <message>
        <source>a line over two planes, with the step between them</source>
        <translation>使用跨过两个平面、台阶位于其间的线</translation>
    </message>
    <message>
        <source>the two sides of the step are not parallel</source>
        <translation>台阶的两侧不平行</translation>
    </message>
    <message>
        <source>a line over two parallel planes, with the step between them</source>
        <translation>使用跨过两个平行平面、台阶位于其间的线</translation>
    </message>
    <message>
        <source>could not save the simulated finger for the next time</source>
        <translation>无法保存仿真手指供下次使用</translation>
    </message>
    <message>
        <source>error of a push&apos;s direction in the image; sides begin at 22.5 degrees and every 45 from there; the paper gives no figure for it</source>
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
        <source>frames under 10 px per dot, or reported as a pose never recorded</source>
        <translation>每点低于 10 px 的帧，或被报告为姿态从未录制过的帧</translation>
    </message>
    <message>
        <source>frames under 10 px summed over the dots, nearest of a recording</source>
        <translation>各点之和低于 10 px 的帧，录像中最近的参考</translation>
    </message>
    <message>
        <source>the same, for the recorded frames as the reference combines them</source>
        <translation>同上，录制的帧按参考的方式组合</translation>
    </message>
    <message>
        <source>the same, or the pose or its surroundings are reported as not recorded</source>
        <translation>同上，或被报告为该姿态或其附近未录制过</translation>
    </message>
    <message>
        <source>as the reference combines them, ours</source>
        <translation>按参考的方式组合，本程序</translation>
    </message>
    <message>
        <source>The paper sums the distance over its dots, and so does the figure under 40 px here; the figure under 10 px covers this finger and {} drawn at random, per dot and summed</source>
        <translation>论文把距离对其各点求和，这里的“小于 40 px”也这样给出；“小于 10 px”则按此手指和随机抽取的 {} 个手指给出，分别为每点的值和总和</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>真值</translation>
    </message>
    <message>
        <source>relief of the straight finger, along the pressed face from base (left) to tip</source>
        <translation>伸直手指的浮雕，沿被压接触面从根部（左）到指尖</translation>
    </message>
    <message>
        <source>relief of the bent finger, along the pressed face from base (left) to tip</source>
        <translation>弯曲手指的浮雕，沿被压接触面从根部（左）到指尖</translation>
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
        <source>The paper shows images of reliefs but no figure; both of ours use the same calibration, so only the reference differs</source>
        <translation>论文给出浮雕的图像，没有数字；本程序的两个结果使用同一标定，因此只有参考不同</translation>
    </message>
    <message>
        <source>no finger was specified to measure these images</source>
        <translation>未指定用来测量这些图像的手指</translation>
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
        <source>is not a setting of this version</source>
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
        <source>this finger has no presets: it was not studied yet</source>
        <translation>此手指没有预设：尚未对它进行研究</translation>
    </message>
    <message>
        <source>alltact study {} --save</source>
        <translation>alltact study {} --save</translation>
    </message>
    <message>
        <source>no setting is faster on this finger without an error half as large again</source>
        <translation>在此手指上，没有哪种设置更快而误差不增大一半</translation>
    </message>
    <message>
        <source>no setting is more accurate on this finger than those of its calibration</source>
        <translation>在此手指上，没有比标定时所用设置更精确的</translation>
    </message>
    <message>
        <source>measuring with {}</source>
        <translation>用 {} 测量</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a preset of this finger</source>
        <translation>“{}”不是此手指的预设</translation>
    </message>
    <message>
        <source>{}</source>
        <translation>{}</translation>
    </message>
    <message>
        <source>beyond the {} to be used</source>
        <translation>超出要使用的 {} 次</translation>
    </message>
    <message>
        <source>maximum number of presses to use, spread evenly over those given; 0: all of them</source>
        <translation>最多使用的按压次数，在所给按压中均匀选取；0：全部</translation>
    </message>
    <message>
        <source>all presses</source>
        <translation>所有按压</translation>
    </message>
    <message>
        <source>more support the curve at more depths and positions; ten well spread are typical</source>
        <translation>越多，曲线就在越多的深度和位置上有依据；通常用十次分布良好的按压</translation>
    </message>
    <message>
        <source>each must be made, and is left out once to test the prediction</source>
        <translation>每次都要实际按压，并会被留出一次以检验预测</translation>
    </message>
    <message>
        <source>maximum number of averaged images of a press held still (--bursts)</source>
        <translation>一次保持静止的按压（--bursts）最多取平均的图像数</translation>
    </message>
    <message>
        <source>more leave less noise in a press, by their square root</source>
        <translation>越多则一次按压中的噪声越小，与张数的平方根成反比</translation>
    </message>
    <message>
        <source>the ball must be held still that long, and reading them takes a little time</source>
        <translation>球须保持静止相应的时间，读取图像也要花一点时间</translation>
    </message>
    <message>
        <source>maximum number of rounds of the joint fit; it ends earlier when nothing changes</source>
        <translation>联合拟合的最多轮数；不再有变化时会提前结束</translation>
    </message>
    <message>
        <source>more resolve contradictions between presses; too few leave the curve where it began</source>
        <translation>越多越能调和各次按压之间的矛盾；太少则曲线停留在起点</translation>
    </message>
    <message>
        <source>each solves all presses together once, in every trial</source>
        <translation>每一轮都在每次试验中把全部按压一起求解一次</translation>
    </message>
    <message>
        <source>the presses do not show whether brightness follows the layer&apos;s thickness along its normal ({:.4f} mm on presses left out) or along z ({:.4f} mm): the normal is assumed; if wrong, positions on the face are {:.1f} mm off along it; use larger images, and presses where the face is steep and where it is flat</source>
        <translation>按压无法表明亮度是随层沿法线的厚度变化（留出按压误差 {:.4f} mm），还是随沿 z 的厚度变化（{:.4f} mm）：现假定为法线；若不对，接触面上的位置会沿接触面偏 {:.1f} mm；请使用更大的图像，以及在接触面陡处和平处的按压</translation>
    </message>
    <message>
        <source>the source paper&apos;s method is not studied with a turned camera</source>
        <translation>不研究相机转动时的原论文方法</translation>
    </message>
    <message>
        <source>{}: median depth error {:.1f} instead of {:.1f} micrometres, 95 % within {:.1f} instead of {:.1f}, for {:.1f} more minutes</source>
        <translation>{}：深度误差中位数为 {:.1f} 而不是 {:.1f} 微米，95 % 在 {:.1f} 而不是 {:.1f} 以内，多用 {:.1f} 分钟</translation>
    </message>
    <message numerus="yes">
        <source>{} presses</source>
        <comment>{} press</comment>
        <translation>
            <numerusform>{} 次按压</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>{} images each</source>
        <comment>{} image each</comment>
        <translation>
            <numerusform>每次 {} 张图像</numerusform>
        </translation>
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
        <source>{} more presses</source>
        <comment>{} more press</comment>
        <translation>
            <numerusform>多 {} 次按压</numerusform>
        </translation>
    </message>
    <message>
        <source>{} images of each press</source>
        <translation>每次按压 {} 张图像</translation>
    </message>
    <message>
        <source>The best within one more minute ({})</source>
        <translation>多用不超过一分钟时的最佳选择（{}）</translation>
    </message>
    <message>
        <source>the finger has too few stored presses to leave one out: {}</source>
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
        <source>none of {} presses could be compared with a mapping made without it</source>
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
        <source>depth error {:.1f} instead of {:.1f} micrometres</source>
        <translation>深度误差为 {:.1f} 而不是 {:.1f} 微米</translation>
    </message>
    <message>
        <source>95 % of depth within {:.1f} instead of {:.1f} micrometres</source>
        <translation>95 % 的深度误差在 {:.1f} 而不是 {:.1f} 微米以内</translation>
    </message>
    <message>
        <source>position error {:.3f} instead of {:.3f} mm</source>
        <translation>位置误差为 {:.3f} 而不是 {:.3f} mm</translation>
    </message>
    <message>
        <source>angle error {:.1f} instead of {:.1f} degrees</source>
        <translation>角度误差为 {:.1f} 而不是 {:.1f} 度</translation>
    </message>
    <message>
        <source>{:.1f} instead of {:.1f} micrometres of false depth</source>
        <translation>虚假深度为 {:.1f} 而不是 {:.1f} 微米</translation>
    </message>
    <message numerus="yes">
        <source>no depth in {} images</source>
        <comment>no depth in {} image</comment>
        <translation>
            <numerusform>{} 张图像中没有深度</numerusform>
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
        <source>the video is not marked as depth</source>
        <translation>视频未标明包含深度</translation>
    </message>
    <message>
        <source>a video from alltact reconstruct --format depth-video</source>
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
        <source>Debian&apos;s libavcodec, or depth as single images</source>
        <translation>使用 Debian 的 libavcodec，或把深度存为单张图像</translation>
    </message>
    <message>
        <source>whether the lens distortion is removed from every point, or the lens is assumed to have none</source>
        <translation>是否从每个点中消除镜头的畸变，或将镜头视为无畸变</translation>
    </message>
    <message>
        <source>lens corrected at every point</source>
        <translation>逐点校正镜头</translation>
    </message>
    <message>
        <source>lens assumed distortion-free</source>
        <translation>将镜头视为无畸变</translation>
    </message>
    <message>
        <source>&apos;exact&apos; measures shape and positions correctly up to the image&apos;s corners</source>
        <translation>&apos;exact&apos; 直到图像角落都能正确给出形状和位置</translation>
    </message>
    <message>
        <source>&apos;exact&apos; looks up each ray separately</source>
        <translation>&apos;exact&apos; 逐条查找每条光线</translation>
    </message>
    <message>
        <source>how a layer pressed in along its normal is converted to z: looked up where the normal leads, or at the same pixel as if all rays were parallel</source>
        <translation>沿法线压入的层如何换算到 z：沿法线所指处查找，或视所有光线为平行而取同一像素</translation>
    </message>
    <message>
        <source>exact rays through the layer</source>
        <translation>穿过层的精确光线</translation>
    </message>
    <message>
        <source>parallel rays through the layer</source>
        <translation>穿过层的平行光线</translation>
    </message>
    <message>
        <source>&apos;exact&apos; measures a contact on a sloping face at its true position and depth; &apos;parallel&apos; up to a layer&apos;s thickness off</source>
        <translation>&apos;exact&apos; 给出斜面上接触的真实位置和深度；&apos;parallel&apos; 的偏差可达一个层厚</translation>
    </message>
    <message>
        <source>&apos;exact&apos; looks up every pixel of a contact once more</source>
        <translation>&apos;exact&apos; 对接触的每个像素再查找一次</translation>
    </message>
    <message>
        <source>contact from {:g} mm of depth</source>
        <translation>深度达 {} mm 算作接触</translation>
    </message>
    <message>
        <source>pixels from one vertex to the next in surfaces that are saved or shown in 3D; 1: every pixel</source>
        <translation>保存或以 3D 显示的曲面中，相邻顶点之间的像素数；1：每个像素</translation>
    </message>
    <message>
        <source>a vertex every {} px</source>
        <translation>每 {} px 一个顶点</translation>
    </message>
    <message>
        <source>1 preserves every measured edge</source>
        <translation>1 保留每条测得的边缘</translation>
    </message>
    <message>
        <source>time and size fall with its square</source>
        <translation>时间和大小随其平方减小</translation>
    </message>
    <message>
        <source>a point lies off the face</source>
        <translation>有一个点不在接触面上</translation>
    </message>
    <message>
        <source>points on the face</source>
        <translation>使用接触面上的点</translation>
    </message>
    <message>
        <source>both points are the same</source>
        <translation>两个点是同一点</translation>
    </message>
    <message>
        <source>two different points</source>
        <translation>使用两个不同的点</translation>
    </message>
    <message>
        <source>the connection&apos;s line was incomplete</source>
        <translation>连接的请求行不完整</translation>
    </message>
    <message>
        <source>ending it with a line break</source>
        <translation>以换行结束它</translation>
    </message>
    <message>
        <source>more data followed the line</source>
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
        <source>&apos;{}&apos; does not request {}</source>
        <translation>“{}”没有请求 {}</translation>
    </message>
    <message>
        <source>there is no part &apos;{}&apos;, only {}</source>
        <translation>没有“{}”这一部分，只有 {}</translation>
    </message>
    <message>
        <source>programs of other users are not accepted</source>
        <translation>不接受其他用户的程序</translation>
    </message>
    <message>
        <source>{} programs are already served</source>
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
        <source>programs could not connect here</source>
        <translation>无法在此接受程序连接</translation>
    </message>
    <message>
        <source>the path is longer than the {} bytes a socket&apos;s path may have</source>
        <translation>路径超过套接字允许的 {} 字节</translation>
    </message>
    <message>
        <source>a shorter one with --socket</source>
        <translation>用 --socket 指定更短的路径</translation>
    </message>
    <message>
        <source>this folder belongs to another user, who could read the data</source>
        <translation>此文件夹属于其他用户，该用户可能读取数据</translation>
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
        <source>something here is not a socket, and it remains unchanged</source>
        <translation>此处有不是套接字的内容，未作改动</translation>
    </message>
    <message>
        <source>another path with --socket</source>
        <translation>用 --socket 指定其他路径</translation>
    </message>
    <message>
        <source>another program already serves here ({})</source>
        <translation>已有另一个程序在此提供服务（{}）</translation>
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
        <source>the edges at the {} are not visible</source>
        <translation>看不到{}处的边缘</translation>
    </message>
    <message>
        <source>bring the entire face into the image, lit, with dark next to it</source>
        <translation>让整个接触面进入图像并被照亮，其旁边保持黑暗</translation>
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
        <source>no face is visible</source>
        <translation>看不到接触面</translation>
    </message>
    <message>
        <source>{:.1f} % of the face is too bright to measure</source>
        <translation>接触面的 {:.1f} % 太亮，无法测量</translation>
    </message>
    <message>
        <source>dim the lamp, or shorten the exposure</source>
        <translation>调暗灯，或缩短曝光</translation>
    </message>
    <message>
        <source>the face has brightness {:.0f} of 255, nothing is too bright</source>
        <translation>接触面的亮度为 {:.0f} / 255，没有过亮处</translation>
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
        <source>no image yet</source>
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
        <source>light the dots evenly, keep both rows in the image, and check how many the finger has</source>
        <translation>均匀照亮标记点，使两排都在图像内，并核对手指有多少标记点</translation>
    </message>
    <message>
        <source>&apos;joint&apos; is several times more accurate, and reports its certainty</source>
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
        <source>&apos;auto&apos; fits all of them and leaves presses out for each</source>
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
        <source>no image of the reference recording shows the face</source>
        <translation>参考录像中没有一张图像显示接触面</translation>
    </message>
    <message>
        <source>how time and memory grow for {}</source>
        <translation>时间和内存如何增长：{}</translation>
    </message>
    <message>
        <source>one frame</source>
        <translation>一帧</translation>
    </message>
    <message>
        <source>pixels of the image</source>
        <translation>图像的像素数</translation>
    </message>
    <message>
        <source>images of {} x {}</source>
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
        <source>{} of {} searches gave the same result as a search of all frames</source>
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
        <source>{} presses are distinct, the others are their copies</source>
        <comment>{} press is distinct, the others are its copies</comment>
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
        <source>{} frames of the longest were measured; memory: the maximum in addition to the reference</source>
        <translation>测量了最长录像的 {} 帧；内存：参考之外占用的最大值</translation>
    </message>
    <message>
        <source>its error is estimated from the third view on</source>
        <translation>从第三个视图起估计其误差</translation>
    </message>
    <message>
        <source>no frame shows a face</source>
        <translation>没有一帧显示接触面</translation>
    </message>
    <message>
        <source>the image cannot be written</source>
        <translation>无法写入图像</translation>
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
        <translation>无法写入图表</translation>
    </message>
    <message>
        <source>there is no space to try the recording</source>
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
        <source>the markers show from which side the finger is pushed, but not how far from its base: a push on a side moves them alike wherever it is</source>
        <translation>标记点能显示手指从哪一侧被推，但不能显示距根部多远：对侧面的推压无论在何处，都以同样方式移动它们</translation>
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
        <source>this is not a list of files to be changed</source>
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
        <source>what the methods of finding markers cost and gain</source>
        <translation>各种标记点查找方法的代价与收益</translation>
    </message>
    <message>
        <source>blobs, the default</source>
        <translation>斑点（默认）</translation>
    </message>
    <message>
        <source>the paper&apos;s rows</source>
        <translation>论文的两排排序</translation>
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
        <source>{}: visible markers that are found</source>
        <translation>{}：可见标记点中被找到的</translation>
    </message>
    <message>
        <source>{}: reported as seen, but elsewhere</source>
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
        <source>visible markers that are found, each frame by itself</source>
        <translation>可见标记点中被找到的，每帧单独处理</translation>
    </message>
    <message>
        <source>found (%)</source>
        <translation>已找到（%）</translation>
    </message>
    <message>
        <source>how far hidden markers are from their reported positions</source>
        <translation>被遮挡标记点与报告位置的距离</translation>
    </message>
    <message>
        <source>root mean square (px)</source>
        <translation>均方根（px）</translation>
    </message>
    <message>
        <source>The demonstration&apos;s finger and {} drawn at random, on which the network was not trained. The recording numbers blobs and network dots; the paper&apos;s rows are numbered from left to right, hidden dots between their neighbours. Each frame is analysed anew, as if none had come before. The paper gives no figure for its markers</source>
        <translation>演示的手指以及随机抽取的 {} 个手指，神经网络未用它们训练过。斑点和神经网络的点按参考录像编号，论文的两排从左到右编号，被遮挡的点编在相邻点之间。每帧都重新分析，不依赖前一帧。论文未给出其标记点的数字</translation>
    </message>
    <message>
        <source>{} was last changed at {}, and this computer&apos;s clock shows {}: set the clock</source>
        <translation>{} 上次更改于 {}，而本机时钟显示 {}：请校准时钟</translation>
    </message>
    <message>
        <source>its disk responds slowly; waiting for it</source>
        <translation>其磁盘响应缓慢，正在等待</translation>
    </message>
    <message>
        <source>wait; if it lasts, check whether another program keeps that disk busy, then its network or cable</source>
        <translation>请稍候；若持续如此，请检查是否有其他程序占用该磁盘，再检查其网络或连接线</translation>
    </message>
    <message>
        <source>the push on the back moves the markers too little, or bends the finger too far, to estimate its distance from the base</source>
        <translation>背面的推压使标记点移动太少，或使手指弯曲过大，无法得出其离根部的距离</translation>
    </message>
    <message>
        <source>The camera&apos;s clock was changed by {:+.1f} s: until it is correct again, the time of arrival of images is used</source>
        <translation>相机的时钟被调整了 {:+.1f} 秒：在它恢复正确之前，图像按到达时间计</translation>
    </message>
    <message>
        <source>The camera sent an image twice ({}): a mean over several images is less certain than reported</source>
        <translation>相机把一张图像发送了两次（{}）：多张图像的平均值不如所示的那样可靠</translation>
    </message>
    <message>
        <source>The report has no pages: {}.</source>
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
        <source>{1:.3f} mm depth error on {0} presses {4} (passes up to {2:.3f} mm), light {3:+.1f} %</source>
        <comment>{1:.3f} mm depth error on {0} press {4} (passes up to {2:.3f} mm), light {3:+.1f} %</comment>
        <translation>
            <numerusform>{0} 次按压（{4}）的深度误差为 {1} mm（不超过 {2} mm 即通过），光照 {3} %</numerusform>
        </translation>
    </message>
    <message>
        <source>left out: {}</source>
        <translation>已排除：{}</translation>
    </message>
    <message>
        <source>too few to judge</source>
        <translation>数量太少，无法判断</translation>
    </message>
    <message>
        <source>a check needs {} images, {} could be measured</source>
        <translation>检查需要 {} 幅图像，可测量的有 {} 幅</translation>
    </message>
    <message>
        <source>camera, face or markers</source>
        <translation>相机、接触面或标记点</translation>
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
        <source>the specified face width is {:.2f} mm, but camera and presses show {}: check the width and the lens</source>
        <translation>给定的接触面宽度为 {} mm，但相机和按压显示为 {}：请核对宽度和镜头</translation>
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
        <source>mostly depth measured next to contacts, as caused by light that scatters sideways</source>
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
        <translation>接触面距离</translation>
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
        <source>no press was left out to show the error on others</source>
        <translation>没有留出按压来检验在其他按压上的误差</translation>
    </message>
    <message>
        <source>one press cannot show the error on others; add presses of different depth</source>
        <translation>一次按压无法说明在其他按压上的误差；请增加不同深度的按压</translation>
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
        <source>the presses do not show how certain the scale is; add presses</source>
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
        <source>next to contacts, {:.3f} mm of depth is measured: light scatters sideways there, or the skin is pressed in</source>
        <translation>接触旁边测得 {} mm 深度：光在那里侧向散射，或表皮被带着下陷</translation>
    </message>
    <message>
        <source>fine relief needs an error of at most {:.2f} mm</source>
        <translation>测量精细浮雕要求误差不超过 {} mm</translation>
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
        <translation>接触面宽 {} mm</translation>
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
        <source>no expected error can be given</source>
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
    <message>
        <source>two points are resolved from {:.2f} mm on; depth is right within a tenth on walls of {:.2f} mm, on pins of {:.2f} mm and {:.2f} mm from a step</source>
        <translation>两点相距 {} mm 起可分辨；宽 {} mm 的薄壁、直径 {} mm 的销以及距台阶 {} mm 处，深度误差在十分之一以内</translation>
    </message>
    <message>
        <source>{}, if light does not scatter sideways</source>
        <translation>{}（前提是光不向侧面散射）</translation>
    </message>
    <message>
        <source>has another number of waves</source>
        <translation>波的数目不同</translation>
    </message>
    <message>
        <source>Light in the layer scatters aside before it comes back</source>
        <translation>光在层内向侧面散射后才返回</translation>
    </message>
    <message>
        <source>two effects for one layer: its light is local or scatters</source>
        <translation>同一层有两个效果：其光要么是局部的，要么散射</translation>
    </message>
    <message>
        <source>naming the effect layer or the effect scatter</source>
        <translation>只写效果 layer 或效果 scatter 之一</translation>
    </message>
    <message>
        <source>of its {} bits per pixel only the lower {} are in use: these were taken as the entire range</source>
        <translation>每像素 {} 位中只用了低 {} 位：已将其作为整个范围</translation>
    </message>
    <message>
        <source>it does not state the range of its brightness: 16 to 235 was assumed</source>
        <translation>未注明亮度范围：按 16 到 235 处理</translation>
    </message>
    <message>
        <source>it does not state the range of its brightness: it has levels below 9, so 0 to 255 was assumed</source>
        <translation>未注明亮度范围：含有低于 9 的灰度，因此按 0 到 255 处理</translation>
    </message>
    <message>
        <source>it is nearly black: no pixel reaches grey level {:.0f} of 255; check light and exposure</source>
        <translation>画面几乎全黑：没有像素达到 255 级中的第 {:.0f} 级；请检查灯光和曝光</translation>
    </message>
    <message>
        <source>{:.0f} % of it is saturated; reduce exposure or light</source>
        <translation>{:.0f} % 的画面已饱和；请减小曝光或灯光</translation>
    </message>
    <message>
        <source>it is in colour: its channels differ from grey by {:.0f} %; only its brightness is used</source>
        <translation>它是彩色的：各通道与灰度相差 {:.0f} %；只使用其亮度</translation>
    </message>
    <message>
        <source>another copy, or recording it again</source>
        <translation>换一个副本，或重新录制</translation>
    </message>
    <message>
        <source>this is no JPEG</source>
        <translation>这不是 JPEG</translation>
    </message>
    <message>
        <source>its header gives {} x {} px</source>
        <translation>其文件头给出 {} x {} px</translation>
    </message>
    <message>
        <source>the JPEG is truncated or damaged</source>
        <translation>该 JPEG 不完整或已损坏</translation>
    </message>
    <message>
        <source>of the 16 bits per pixel only the lower {} are in use: these are taken as the entire range</source>
        <translation>每像素 16 位中只用了低 {} 位：将其作为整个范围</translation>
    </message>
    <message>
        <source>its JPEGs contain stray bytes, which cost no pixel</source>
        <translation>其 JPEG 含有多余字节，但不影响任何像素</translation>
    </message>
    <message>
        <source>this system&apos;s libavcodec cannot read H.264</source>
        <translation>本系统的 libavcodec 无法读取 H.264</translation>
    </message>
    <message>
        <source>another format of the camera</source>
        <translation>相机的另一种格式</translation>
    </message>
    <message>
        <source>H.264 cannot be decoded</source>
        <translation>无法解码 H.264</translation>
    </message>
    <message>
        <source>a frame of H.264 is damaged</source>
        <translation>一帧 H.264 图像已损坏</translation>
    </message>
    <message>
        <source>the image has {} bits per channel (floating point); 8 to 16 as integers are needed</source>
        <translation>图像每通道为 {} 位（浮点）；需要 8 到 16 位整数</translation>
    </message>
    <message>
        <source>the camera&apos;s own images</source>
        <translation>相机本身的图像</translation>
    </message>
    <message>
        <source>16 bits per pixel were reduced to 8</source>
        <translation>每像素 16 位已缩减为 8 位</translation>
    </message>
    <message>
        <source>of 16 bits per pixel only the lower {} are in use: these were taken as the entire range</source>
        <translation>每像素 16 位中仅用了低 {} 位：已将其作为整个范围</translation>
    </message>
    <message>
        <source>viewers are asked to turn them (Exif orientation {}), which is not done here: the camera&apos;s orientation is a setting of the finger</source>
        <translation>标签要求查看器旋转它们（Exif 方向 {}），此处未旋转：相机方向是手指的一项设置</translation>
    </message>
    <message>
        <source>png, jpg, bmp, tif or pgm images, a video that players open, or a yaml scene</source>
        <translation>png、jpg、bmp、tif 或 pgm 图像，播放器能打开的视频，或 yaml 场景</translation>
    </message>
    <message>
        <source>stopped before the video was open</source>
        <translation>视频打开之前已停止</translation>
    </message>
    <message>
        <source>looking for the order of the video&apos;s frames</source>
        <translation>正在确定视频各帧的顺序</translation>
    </message>
    <message>
        <source>{} of its {} frames cannot be decoded and are missing</source>
        <translation>其 {1} 帧中有 {0} 帧无法解码，已缺失</translation>
    </message>
    <message>
        <source>it asks viewers to turn it by {} degrees, which is not done here: the camera&apos;s orientation is a setting of the finger</source>
        <translation>它要求查看器旋转 {} 度，此处未旋转：相机方向是手指的一项设置</translation>
    </message>
    <message>
        <source>The images</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Images of the camera</source>
        <translation>相机图像</translation>
    </message>
    <message>
        <source>AprilGrid</source>
        <translation>AprilGrid</translation>
    </message>
    <message>
        <source>no markers in the order of this board are visible</source>
        <translation>看不到按此标定板顺序排列的标记</translation>
    </message>
    <message>
        <source>the markers of this board are of the dictionary {}, not {}</source>
        <translation>此标定板的标记属于字典 {}，而不是 {}</translation>
    </message>
    <message>
        <source>--dictionary {}</source>
        <translation>--dictionary {}</translation>
    </message>
    <message>
        <source>this image is mirrored, unlike others</source>
        <translation>此图像是镜像的，与其他图像不同</translation>
    </message>
    <message>
        <source>images from one camera in one mode</source>
        <translation>同一相机同一模式下的图像</translation>
    </message>
    <message>
        <source>only {} of the board&apos;s corners are visible, {} are needed</source>
        <translation>标定板只有 {} 个角点可见，需要 {} 个</translation>
    </message>
    <message>
        <source>only corners in one line of the board are visible</source>
        <translation>标定板可见的角点都在一条直线上</translation>
    </message>
    <message>
        <source>the markers of this board are of the dictionary {}</source>
        <translation>此标定板的标记属于字典 {}</translation>
    </message>
    <message>
        <source>this board has the layout of OpenCV before 4.6 and of calib.io: its first square is white</source>
        <translation>此标定板采用 OpenCV 4.6 之前版本和 calib.io 的布局：第一个方格为白色</translation>
    </message>
    <message>
        <source>the first square of this board is white, with a marker</source>
        <translation>此标定板的第一个方格为白色并带有标记</translation>
    </message>
    <message>
        <source>this board has the layout of OpenCV from 4.6 on: its first square is black</source>
        <translation>此标定板采用 OpenCV 4.6 及以后版本的布局：第一个方格为黑色</translation>
    </message>
    <message>
        <source>the markers of this board are counted from {}</source>
        <translation>此标定板的标记从 {} 开始编号</translation>
    </message>
    <message>
        <source>the board is mirrored in these images; the lens is valid for images that are mirrored in the same direction</source>
        <translation>标定板在这些图像中是镜像的；镜头参数只适用于同样镜像的图像</translation>
    </message>
    <message>
        <source>black and white of this board are exchanged</source>
        <translation>此标定板的黑白颠倒</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %: a board with squares that are {:.1f} % {} than high explains it, and pixels are then square; measure the board&apos;s width and height with a caliper, and print it without scaling</source>
        <translation>fx 与 fy 相差 {0} %：如果标定板方格的宽比高{2} {1} %，就能解释这一差异，此时像素为正方形；请用卡尺测量标定板的宽和高，并且打印时不要缩放</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %, although the board is square within {:.1f} %: the camera stretches its images, or its pixels are not square</source>
        <translation>fx 与 fy 相差 {} %，但标定板在 {} % 以内为正方形：相机拉伸了图像，或者像素不是正方形</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %: a board printed {:.1f} % {} than high and pixels that are not square look alike in these views. The board is likelier: measure its width and height with a caliper, and turn it by 90 degrees in half of the views</source>
        <translation>fx 与 fy 相差 {0} %：打印时宽比高{2} {1} % 的标定板与非正方形像素在这些视图中无法区分。更可能是标定板的问题：请用卡尺测量其宽和高，并在一半的视图中将其旋转 90 度</translation>
    </message>
    <message>
        <source>with squares of this size the boards are {:.2g} mm from the lens, and the finger {:g} mm: give --square-mm in millimetres, not in {}</source>
        <translation>按此方格尺寸，标定板距镜头 {} mm，而手指距镜头 {} mm：--square-mm 应以毫米为单位，而不是{}</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>微米</translation>
    </message>
    <message>
        <source>ChArUco, AprilGrid: family of the markers; any tries all</source>
        <translation>ChArUco、AprilGrid：标记字典；any 表示逐一尝试</translation>
    </message>
    <message>
        <source>AprilGrid: gap of two tags as a fraction of a tag&apos;s side</source>
        <translation>AprilGrid：标签间隔与标签边长之比</translation>
    </message>
    <message>
        <source>asymmetric dots</source>
        <translation>交错圆点</translation>
    </message>
    <message>
        <source>tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>inner corners are counted, not squares</source>
        <translation>数的是内角点，不是方格</translation>
    </message>
    <message>
        <source>tags of a row and of a column are counted</source>
        <translation>数的是一行和一列的标签</translation>
    </message>
    <message>
        <source>dots of a row and of a column are counted</source>
        <translation>数的是一行和一列的圆点</translation>
    </message>
    <message>
        <source>this board has {}, not {} x {}</source>
        <translation>此标定板有 {}，而不是 {} x {}</translation>
    </message>
    <message>
        <source>--board {}x{}: {}</source>
        <translation>--board {}x{}：{}</translation>
    </message>
    <message>
        <source>this board is {}</source>
        <translation>此标定板是{}</translation>
    </message>
    <message>
        <source>a ChArUco board</source>
        <translation>ChArUco 板</translation>
    </message>
    <message>
        <source>an AprilGrid</source>
        <translation>AprilGrid</translation>
    </message>
    <message>
        <source>a chessboard with {}</source>
        <translation>{}的棋盘格</translation>
    </message>
    <message>
        <source>a symmetric grid with {}</source>
        <translation>{}的对称网格</translation>
    </message>
    <message>
        <source>a grid with {}</source>
        <translation>{}的网格</translation>
    </message>
    <message>
        <source>two halves of the views give {} = {:.1f} and {:.1f} px</source>
        <translation>两半视图分别给出 {} = {} 和 {} px</translation>
    </message>
    <message>
        <source>fx and fy differ by {:.1f} %: the board is likely out of square</source>
        <translation>fx 与 fy 相差 {} %：标定板的长宽比例很可能不准</translation>
    </message>
    <message>
        <source>the squares of the board are stretched by {:.1f} %</source>
        <translation>标定板的方格被拉伸了 {} %</translation>
    </message>
    <message>
        <source>the board is bent by about {:.2g} mm</source>
        <translation>标定板弯曲约 {} mm</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is given twice</source>
        <translation>“{}”给出了两次</translation>
    </message>
    <message>
        <source>an alias stands for nothing</source>
        <translation>别名没有对应的内容</translation>
    </message>
    <message>
        <source>this is not XML: {}</source>
        <translation>这不是 XML：{}</translation>
    </message>
    <message>
        <source>copy the file again</source>
        <translation>重新复制该文件</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>括号没有闭合</translation>
    </message>
    <message>
        <source>is a MAT-file, which is not text</source>
        <translation>是 MAT 文件，不是文本</translation>
    </message>
    <message>
        <source>in Matlab: writelines(jsonencode(toStruct(cameraParams)), &apos;camera.json&apos;)</source>
        <translation>在 Matlab 中：writelines(jsonencode(toStruct(cameraParams)), &apos;camera.json&apos;)</translation>
    </message>
    <message>
        <source>is a packed archive</source>
        <translation>是压缩包</translation>
    </message>
    <message>
        <source>unpack it, and use a file of it</source>
        <translation>解压后使用其中的文件</translation>
    </message>
    <message>
        <source>is no text file</source>
        <translation>不是文本文件</translation>
    </message>
    <message>
        <source>a calibration as YAML, JSON or XML</source>
        <translation>YAML、JSON 或 XML 格式的标定</translation>
    </message>
    <message>
        <source>brown: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, fisheye: k1 k2 k3 k4, others: []</source>
        <translation>brown：k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4，fisheye：k1 k2 k3 k4，其他：[]</translation>
    </message>
    <message>
        <source>keys that are not known here were not read: {}</source>
        <translation>以下键在此未知，未被读取：{}</translation>
    </message>
    <message>
        <source>a camera file of this program</source>
        <translation>本程序的相机文件</translation>
    </message>
    <message>
        <source>is a key of other programs, whose numbers would be lost here</source>
        <translation>是其他程序的键，其数值在此会丢失</translation>
    </message>
    <message>
        <source>the other program&apos;s file unchanged, or &apos;distortion: [...]&apos; instead of it</source>
        <translation>使用其他程序的原始文件，或改写为 &apos;distortion: [...]&apos;</translation>
    </message>
    <message>
        <source>no distortion</source>
        <translation>无畸变</translation>
    </message>
    <message>
        <source>read as {}: {} x {} px, {:g} mm per px</source>
        <translation>读作{}：{} x {} px，每 px {} mm</translation>
    </message>
    <message>
        <source>read as {}: {} x {} px, fx {:.1f}, {}</source>
        <translation>读作{}：{} x {} px，fx {}，{}</translation>
    </message>
    <message>
        <source>ends in the middle of a list, as a file that was cut off</source>
        <translation>在列表中间结束，像是被截断的文件</translation>
    </message>
    <message>
        <source>copy the file again, or end its last line with a line break</source>
        <translation>重新复制该文件，或在最后一行末尾加换行</translation>
    </message>
    <message>
        <source>is a block without &apos;data&apos;</source>
        <translation>是没有 &apos;data&apos; 的块</translation>
    </message>
    <message>
        <source>holds more numbers than a camera has</source>
        <translation>含有的数多于相机所有的</translation>
    </message>
    <message>
        <source>holds &apos;{}&apos;, which is not a finite number</source>
        <translation>含有“{}”，不是有限的数</translation>
    </message>
    <message>
        <source>holds {} numbers instead of {}</source>
        <translation>含有 {} 个数，而不是 {} 个</translation>
    </message>
    <message>
        <source>must be a single number</source>
        <translation>必须是单个数</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is missing</source>
        <translation>缺少“{}”</translation>
    </message>
    <message>
        <source>contradicts &apos;{}&apos;</source>
        <translation>与“{}”矛盾</translation>
    </message>
    <message>
        <source>delete the one that is wrong</source>
        <translation>删除错误的那一项</translation>
    </message>
    <message>
        <source>{:g} x {:g} is no image size</source>
        <translation>{} x {} 不是图像尺寸</translation>
    </message>
    <message>
        <source>holds no width and height</source>
        <translation>不含宽度和高度</translation>
    </message>
    <message>
        <source>is 0: this camera is not calibrated</source>
        <translation>为 0：该相机未标定</translation>
    </message>
    <message>
        <source>a calibration, as of &apos;alltact lens&apos;</source>
        <translation>先标定，例如用 &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>is no camera matrix, with the last row 0 0 1</source>
        <translation>不是末行为 0 0 1 的相机矩阵</translation>
    </message>
    <message>
        <source>the matrix [fx, 0, cx, 0, fy, cy, 0, 0, 1]</source>
        <translation>矩阵 [fx, 0, cx, 0, fy, cy, 0, 0, 1]</translation>
    </message>
    <message>
        <source>has a skew of {:g}, which the camera here cannot have</source>
        <translation>有 {} 的倾斜系数，此处的相机不支持</translation>
    </message>
    <message>
        <source>calibrate again without skew</source>
        <translation>不带倾斜系数重新标定</translation>
    </message>
    <message>
        <source>the lens model &apos;{}&apos; cannot be expressed here</source>
        <translation>镜头模型“{}”在此无法表示</translation>
    </message>
    <message>
        <source>has {} coefficients; a fisheye has 4</source>
        <translation>有 {} 个系数；鱼眼镜头有 4 个</translation>
    </message>
    <message>
        <source>has {} coefficients; OpenCV knows 4, 5, 8, 12 and 14</source>
        <translation>有 {} 个系数；OpenCV 支持 4、5、8、12 和 14 个</translation>
    </message>
    <message>
        <source>describes a tilted sensor, which cannot be expressed here</source>
        <translation>描述了倾斜的传感器，在此无法表示</translation>
    </message>
    <message>
        <source>calibrate again without CALIB_TILTED_MODEL, or run &apos;alltact lens&apos;</source>
        <translation>不用 CALIB_TILTED_MODEL 重新标定，或运行 &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>has coefficients, while the file names no lens model</source>
        <translation>有系数，但文件没有写明镜头模型</translation>
    </message>
    <message>
        <source>add the model&apos;s name, such as plumb_bob</source>
        <translation>补上模型名，例如 plumb_bob</translation>
    </message>
    <message>
        <source>run &apos;alltact lens&apos; with images of a board</source>
        <translation>用标定板图像运行 &apos;alltact lens&apos;</translation>
    </message>
    <message>
        <source>the camera bins its images by {:g}, while its matrix holds for full images</source>
        <translation>相机按 {} 合并像素，而其矩阵适用于完整图像</translation>
    </message>
    <message>
        <source>the camera without binning, and &apos;binning_x: 1&apos;, &apos;binning_y: 1&apos;</source>
        <translation>关闭像素合并，并写 &apos;binning_x: 1&apos;、&apos;binning_y: 1&apos;</translation>
    </message>
    <message>
        <source>the camera sends a part of its image, while its matrix holds for all</source>
        <translation>相机只发送部分图像，而其矩阵适用于完整图像</translation>
    </message>
    <message>
        <source>the camera without a region of interest, and a file without &apos;roi&apos;</source>
        <translation>关闭感兴趣区域，并使用没有 &apos;roi&apos; 的文件</translation>
    </message>
    <message>
        <source>the camera matrix is missing</source>
        <translation>缺少相机矩阵</translation>
    </message>
    <message>
        <source>add &apos;camera_matrix: [fx, 0, cx, 0, fy, cy, 0, 0, 1]&apos;</source>
        <translation>补上 &apos;camera_matrix: [fx, 0, cx, 0, fy, cy, 0, 0, 1]&apos;</translation>
    </message>
    <message>
        <source>a ROS camera_info file</source>
        <translation>ROS camera_info 文件</translation>
    </message>
    <message>
        <source>an OpenCV calibration</source>
        <translation>OpenCV 标定</translation>
    </message>
    <message>
        <source>the distortion coefficients are missing</source>
        <translation>缺少畸变系数</translation>
    </message>
    <message>
        <source>add &apos;distortion_coefficients: [0, 0, 0, 0, 0]&apos; where there is no distortion</source>
        <translation>若无畸变，补上 &apos;distortion_coefficients: [0, 0, 0, 0, 0]&apos;</translation>
    </message>
    <message>
        <source>no lens model is named, so that the 4 coefficients are read as k1 k2 p1 p2; for a fisheye add &apos;distortion_model: fisheye&apos;</source>
        <translation>没有写明镜头模型，因此 4 个系数读作 k1 k2 p1 p2；若是鱼眼镜头，请补上 &apos;distortion_model: fisheye&apos;</translation>
    </message>
    <message>
        <source>a Kalibr camera chain</source>
        <translation>Kalibr 相机链</translation>
    </message>
    <message>
        <source>calibrate again with pinhole-radtan or pinhole-equi</source>
        <translation>用 pinhole-radtan 或 pinhole-equi 重新标定</translation>
    </message>
    <message>
        <source>an mrcal camera model</source>
        <translation>mrcal 相机模型</translation>
    </message>
    <message>
        <source>convert it with mrcal-convert-lensmodel to LENSMODEL_OPENCV8</source>
        <translation>用 mrcal-convert-lensmodel 转换为 LENSMODEL_OPENCV8</translation>
    </message>
    <message>
        <source>a PhotonVision calibration</source>
        <translation>PhotonVision 标定</translation>
    </message>
    <message>
        <source>calibrate again with LENSMODEL_OPENCV</source>
        <translation>用 LENSMODEL_OPENCV 重新标定</translation>
    </message>
    <message>
        <source>Matlab&apos;s camera parameters</source>
        <translation>Matlab 相机参数</translation>
    </message>
    <message>
        <source>the focal lengths are missing</source>
        <translation>缺少焦距</translation>
    </message>
    <message>
        <source>a calibration.json of this program</source>
        <translation>本程序的 calibration.json</translation>
    </message>
    <message>
        <source>a newer version of this program</source>
        <translation>使用本程序的较新版本</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not known here</source>
        <translation>“{}”在此未知</translation>
    </message>
    <message>
        <source>none, flip_u, flip_v, rotate_180, rotate_90 or rotate_270</source>
        <translation>none、flip_u、flip_v、rotate_180、rotate_90 或 rotate_270</translation>
    </message>
    <message>
        <source>the image size is missing</source>
        <translation>缺少图像尺寸</translation>
    </message>
    <message>
        <source>add image_width and image_height of the calibrated images, in pixels</source>
        <translation>补上标定图像的 image_width 和 image_height（像素）</translation>
    </message>
    <message>
        <source>the principal point {:.1f}, {:.1f} lies outside the image of {} x {} px</source>
        <translation>主点 {}, {} 位于 {} x {} px 的图像之外</translation>
    </message>
    <message>
        <source>the size [width, height] of the images that were calibrated</source>
        <translation>所标定图像的尺寸 [宽、高]</translation>
    </message>
    <message>
        <source>holds parameters of a ROS node, without focal lengths</source>
        <translation>含有 ROS 节点的参数，没有焦距</translation>
    </message>
    <message>
        <source>camera_info.yaml of the same export</source>
        <translation>同一次导出的 camera_info.yaml</translation>
    </message>
    <message>
        <source>holds no camera that is known here</source>
        <translation>不含此处可识别的相机</translation>
    </message>
    <message>
        <source>a file of &apos;alltact lens&apos;, ROS, OpenCV, Kalibr, mrcal, PhotonVision or Matlab</source>
        <translation>&apos;alltact lens&apos;、ROS、OpenCV、Kalibr、mrcal、PhotonVision 或 Matlab 的文件</translation>
    </message>
    <message>
        <source>holds no camera &apos;{}&apos;</source>
        <translation>不含相机“{}”</translation>
    </message>
    <message>
        <source>holds {} cameras: {}</source>
        <translation>含有 {} 个相机：{}</translation>
    </message>
    <message>
        <source>one of them by its name: &apos;{}#{}&apos;</source>
        <translation>用名称指定其中一个：&apos;{}#{}&apos;</translation>
    </message>
    <message numerus="yes">
        <source>{1} with {0} coefficients</source>
        <comment>{1} with {0} coefficient</comment>
        <translation>
            <numerusform>{1}，{0} 个系数</numerusform>
        </translation>
    </message>
    <message>
        <source>holds no number</source>
        <translation>不含数</translation>
    </message>
    <message>
        <source>the principal point {:.1f}, {:.1f} is the middle of {} x {} px, not of {} x {}</source>
        <translation>主点 {}, {} 是 {} x {} px 的中心，而不是 {} x {} 的</translation>
    </message>
    <message>
        <source>no program on this computer opens this file</source>
        <translation>此计算机上没有程序能打开此文件</translation>
    </message>
    <message>
        <source>install one, such as a web browser for reports, or open the file on another computer</source>
        <translation>安装一个程序（例如用于报告的网页浏览器），或在另一台计算机上打开该文件</translation>
    </message>
    <message>
        <source>the visible part of the contact face is not indented</source>
        <translation>接触面的可见部分没有被压入</translation>
    </message>
    <message>
        <source>too little of the face is pressed in to find the body&apos;s pose</source>
        <translation>接触面被压入的部分太少，无法确定物体的位姿</translation>
    </message>
    <message>
        <source>a frame with a deeper or wider contact</source>
        <translation>一帧接触更深或更宽的图像</translation>
    </message>
    <message>
        <source>a mesh of the body that presses, in millimetres</source>
        <translation>压入物体的网格，单位为毫米</translation>
    </message>
    <message>
        <source>stopped before the body was compared</source>
        <translation>在比较物体之前已停止</translation>
    </message>
    <message>
        <source>must be four numbers from 0 to 1000</source>
        <translation>必须是 0 到 1000 之间的四个数</translation>
    </message>
    <message>
        <source>the standard deviations of fx, fy, cx and cy in pixels, or none</source>
        <translation>fx、fy、cx、cy 的标准差（像素），或不写</translation>
    </message>
    <message>
        <source>the recording is not complete</source>
        <translation>录像不完整</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>请重新录制</translation>
    </message>
    <message>
        <source>neighbouring frames represent it: the recording is long</source>
        <translation>由相邻帧代表：录像较长</translation>
    </message>
    <message>
        <source>the deepest point is at a limit of the measuring range</source>
        <translation>最深处位于测量范围的极限</translation>
    </message>
    <message>
        <source>a shallower contact</source>
        <translation>较浅的接触</translation>
    </message>
    <message>
        <source>the line ends before half of its greatest depth</source>
        <translation>线在其最大深度的一半之前结束</translation>
    </message>
    <message>
        <source>a line across the entire contact</source>
        <translation>横跨整个接触的线</translation>
    </message>
    <message>
        <source>the other finger is not calibrated yet</source>
        <translation>另一个手指尚未标定</translation>
    </message>
    <message>
        <source>calibrating it, or choosing another one</source>
        <translation>标定它，或选择另一个</translation>
    </message>
    <message>
        <source>there is no recording</source>
        <translation>没有录像</translation>
    </message>
    <message>
        <source>stopped before all recordings were inspected</source>
        <translation>在检视完所有录像之前停止</translation>
    </message>
</context>
<context>
    <name>alltact::CopyFigure</name>
    <message>
        <source>Copied: %1 × %2 px</source>
        <translation>已复制：%1 × %2 px</translation>
    </message>
    <message>
        <source>&amp;Copy the figure</source>
        <translation>复制图形(&amp;C)</translation>
    </message>
</context>
<context>
    <name>alltact::ForceDialog</name>
    <message>
        <source>train the forces</source>
        <translation>训练力模型</translation>
    </message>
    <message>
        <source>mean force</source>
        <translation>平均力</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation>二次</translation>
    </message>
    <message>
        <source>network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Train the forces</source>
        <translation>训练力模型</translation>
    </message>
    <message>
        <source>A table has the markers&apos; positions of each frame and the forces of a gauge, as alltact force --collect writes it. Each stretch is held out once to measure the error.</source>
        <translation>表中有每帧的标记点位置和测力计的力，可用 alltact force --collect 生成。每一段都会被留出一次，用来测量误差。</translation>
    </message>
    <message>
        <source>Choose &amp;tables…</source>
        <translation>选择表(&amp;T)…</translation>
    </message>
    <message>
        <source>One or more tables of this finger (CSV); training begins at once</source>
        <translation>此手指的一个或多个表（CSV）；立即开始训练</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Ends the training without a result</source>
        <translation>结束训练，没有结果</translation>
    </message>
    <message>
        <source>&amp;Install</source>
        <translation>采用(&amp;I)</translation>
    </message>
    <message>
        <source>Forces come from this model from now on; undo restores the one before</source>
        <translation>此后由此模型计算力；撤销可恢复之前的模型</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>Forgets this result; the finger stays as it is</source>
        <translation>放弃此结果；手指保持不变</translation>
    </message>
    <message>
        <source>Progress of the training</source>
        <translation>训练进度</translation>
    </message>
    <message>
        <source>Errors on held-out frames</source>
        <translation>留出帧的误差</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Mean error, N</source>
        <translation>平均误差，N</translation>
    </message>
    <message>
        <source>R²</source>
        <translation>R²</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>选中</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>表</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口（Esc）</translation>
    </message>
    <message>
        <source>Tables of markers and forces</source>
        <translation>标记点和力的表</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv)</source>
        <translation>表 (*.csv *.txt *.tsv)</translation>
    </message>
    <message>
        <source>No table yet.</source>
        <translation>还没有表。</translation>
    </message>
    <message>
        <source>The model is installed.</source>
        <translation>模型已采用。</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Of the held-out frames %1 % lie within the 95 % interval; the gauge&apos;s noise is at most %2 N. Values are by axis: Fx, Fy, Fz.</source>
        <translation>留出的帧中有 %1 % 落在 95 % 区间内；测力计的噪声不超过 %2 N。各值按轴排列：Fx、Fy、Fz。</translation>
    </message>
</context>
<context>
    <name>alltact::SidePanel</name>
    <message>
        <source>Drag: width of the panel. Double click: as at first.</source>
        <translation>拖动：面板宽度。双击：恢复初始宽度。</translation>
    </message>
</context>
<context>
    <name>alltact::FrameChooser</name>
    <message>
        <source>Leave &amp;out the selected frames</source>
        <translation>舍弃选中的帧(&amp;O)</translation>
    </message>
    <message>
        <source>Leave &amp;out %1</source>
        <translation>舍弃%1(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>使用%1(&amp;U)</translation>
    </message>
    <message>
        <source>leave out %1</source>
        <translation>舍弃%1</translation>
    </message>
    <message>
        <source>use %1</source>
        <translation>使用%1</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>frames %1 to %2</source>
        <translation>第 %1 至 %2 帧</translation>
    </message>
    <message>
        <source>Select frames in the strip: drag, or press Shift and an arrow key.</source>
        <translation>在条带中选择帧：拖动，或按 Shift 和方向键。</translation>
    </message>
    <message>
        <source>Show the live i&amp;mage</source>
        <translation>显示实时图像(&amp;M)</translation>
    </message>
    <message>
        <source>Frame %1 of the recording</source>
        <translation>录像的第 %1 帧</translation>
    </message>
    <message>
        <source>darkest spot: %1 % darker</source>
        <translation>最暗处：暗 %1 %</translation>
    </message>
    <message>
        <source>darkest in frame %1</source>
        <translation>第 %1 帧中最暗</translation>
    </message>
</context>
<context>
    <name>alltact::FrameTable</name>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>时间，s</translation>
    </message>
</context>
<context>
    <name>alltact::RecordingsInspection</name>
    <message>
        <source>Save the table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Inspection of a folder</source>
        <translation>检视文件夹</translation>
    </message>
    <message>
        <source>Readings of each recording</source>
        <translation>每个录像的读数</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录像</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>离散</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>未定</translation>
    </message>
    <message>
        <source>Progress of the inspection</source>
        <translation>检视进度</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Ends the inspection without a result</source>
        <translation>结束检视，不产生结果</translation>
    </message>
    <message>
        <source>Save &amp;table (CSV)…</source>
        <translation>保存表格 (CSV)(&amp;T)…</translation>
    </message>
    <message>
        <source>The table that alltact inspect --each writes, to the byte</source>
        <translation>与 alltact inspect --each 写出的表格逐字节相同</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口 (Esc)</translation>
    </message>
    <message>
        <source>The recordings are being measured…</source>
        <translation>正在测量录像…</translation>
    </message>
    <message>
        <source>Nothing was inspected.</source>
        <translation>未检视任何内容。</translation>
    </message>
    <message>
        <source>Written: %1.</source>
        <translation>已写入：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) inspected.</source>
        <translation>
            <numerusform>已检视 %n 个录像。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s), of which %1 could not be inspected.</source>
        <translation>
            <numerusform>%n 个录像，其中 %1 个无法检视。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::RecordingsDialog</name>
    <message>
        <source>Recordings of %1</source>
        <translation>%1 的录像</translation>
    </message>
    <message>
        <source>Recordings, newest first</source>
        <translation>录像，最新的在前</translation>
    </message>
    <message>
        <source>Double click or Return opens a recording; Delete moves it to the trash</source>
        <translation>双击或按回车打开录像；按 Delete 移到回收站</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Show in folder</source>
        <translation>在文件夹中显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Move to the trash…</source>
        <translation>移到回收站(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Move to the trash</source>
        <translation>移到回收站(&amp;M)</translation>
    </message>
    <message>
        <source>Move to the trash</source>
        <translation>移到回收站</translation>
    </message>
    <message>
        <source>Move %1 to the trash?</source>
        <translation>将 %1 移到回收站？</translation>
    </message>
    <message>
        <source>Opens the selected recording on this page (Return)</source>
        <translation>在此页面打开所选录像（回车）</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Closes this window (Esc)</source>
        <translation>关闭此窗口 (Esc)</translation>
    </message>
    <message>
        <source>The folder is being read.</source>
        <translation>正在读取文件夹。</translation>
    </message>
    <message>
        <source>The finger&apos;s folder has no video yet.</source>
        <translation>手指的文件夹中还没有视频。</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>The finger&apos;s reference</source>
        <translation>手指的参考</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>%1 cannot be moved to the trash. Delete it in its folder.</source>
        <translation>无法将 %1 移到回收站。请在其文件夹中删除。</translation>
    </message>
</context>
</TS>
