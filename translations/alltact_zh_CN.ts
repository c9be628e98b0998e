<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Figures</name>
    <message>
        <source>Residual (mm)</source>
        <translation>残差 (mm)</translation>
    </message>
    <message>
        <source>Error, left out (mm)</source>
        <translation>留出误差 (mm)</translation>
    </message>
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
        <translation>按压深度,%1 (mm)</translation>
    </message>
    <message>
        <source>along the normal</source>
        <translation>沿法线</translation>
    </message>
    <message>
        <source>projected</source>
        <translation>投影</translation>
    </message>
</context>
<context>
    <name>alltact::CalibratePlace</name>
    <message>
        <source>&amp;Next: %1</source>
        <translation>下一步:%1(&amp;N)</translation>
    </message>
</context>
<context>
    <name>alltact::CalibrationRun</name>
    <message>
        <source>calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>The command line, alltact, is not installed beside this program.</source>
        <translation>命令行程序 alltact 没有与本程序一起安装。</translation>
    </message>
</context>
<context>
    <name>alltact::CheckPage</name>
    <message>
        <source>Pass</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>Drifting</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>Recalibrate</source>
        <translation>需要重新标定</translation>
    </message>
    <message>
        <source>Three presses</source>
        <translation>三次按压</translation>
    </message>
    <message>
        <source>Is it still what it was?</source>
        <translation>它还和原来一样吗?</translation>
    </message>
    <message>
        <source>Press the ball of the calibration in at three places, base, middle and tip, and take a picture of each. The calibration stays as it is.</source>
        <translation>用标定时的球在根部、中部和指尖三处压入,各拍一张。标定保持不变。</translation>
    </message>
    <message>
        <source>&amp;Take a press (Space)</source>
        <translation>拍摄按压(空格)(&amp;T)</translation>
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
        <translation>没有实时画面:请选择来源。</translation>
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
        <source>Checked last on %1.</source>
        <translation>上次检查:%1。</translation>
    </message>
    <message>
        <source>%1 of %2 taken.</source>
        <translation>已拍摄 %1 / %2。</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
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
        <translation>已锁定:请在上方解锁后再改。</translation>
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
        <translation>自动模式保持关闭,自行变化的设置会被恢复。</translation>
    </message>
    <message>
        <source>Brightness is the measurement: locked, nothing changes it. Unlock it before calibrating only.</source>
        <translation>亮度就是测量值:锁定后不会改变。仅在标定之前解锁。</translation>
    </message>
    <message>
        <source>A camera&apos;s exposure, gain, white balance and focus stand here. This source is no camera.</source>
        <translation>相机的曝光、增益、白平衡和对焦显示在这里。当前来源不是相机。</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
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
        <source>All directions are reached.</source>
        <translation>所有方向都已达到。</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>缺少:%1。</translation>
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
        <translation>手指 %1 学到的内容,供其他程序使用。</translation>
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
        <translation>相机矩阵和畸变,供 cv::FileStorage 读取。</translation>
    </message>
    <message>
        <source>&amp;ROS: camera_info.yaml and parameters.yaml</source>
        <translation>ROS:camera_info.yaml 和 parameters.yaml(&amp;R)</translation>
    </message>
    <message>
        <source>The camera as drivers and image_pipeline read it; face, markers and mapping as parameters of a ROS 2 node.</source>
        <translation>驱动程序和 image_pipeline 所读的相机;面、标记点和映射作为 ROS 2 节点的参数。</translation>
    </message>
    <message>
        <source>&amp;JSON: calibration.json</source>
        <translation>JSON:calibration.json(&amp;J)</translation>
    </message>
    <message>
        <source>All figures in one file, for programs of your own.</source>
        <translation>全部数值放在一个文件中,供自己的程序使用。</translation>
    </message>
    <message>
        <source>&amp;Whole finger: finger.zip</source>
        <translation>整个手指:finger.zip(&amp;W)</translation>
    </message>
    <message>
        <source>Every file of the finger, its untouched pictures too: to keep, to send, and to measure with in Python.</source>
        <translation>手指的所有文件,包括未触碰的图像:用于保存、发送,以及在 Python 中测量。</translation>
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
        <translation>已写入:%1。</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>打开文件夹</translation>
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
        <translation>沿手指,从根部 (mm)</translation>
    </message>
    <message>
        <source>Along the picture, from the left (mm)</source>
        <translation>沿图像,从左侧 (mm)</translation>
    </message>
    <message>
        <source>Across (mm)</source>
        <translation>横向 (mm)</translation>
    </message>
</context>
<context>
    <name>alltact::FaceView</name>
    <message>
        <source>Face in 3D</source>
        <translation>接触面三维视图</translation>
    </message>
</context>
<context>
    <name>alltact::FingerPage</name>
    <message>
        <source>A flat, rigid sensor with a layer of %1 mm, %2 mm before the camera.</source>
        <translation>平面刚性传感器:层厚 %1 mm,距相机 %2 mm。</translation>
    </message>
    <message>
        <source>A Fin Ray finger whose face is %1 mm wide, with a layer of %2 mm and %3 dots on each side.</source>
        <translation>Fin Ray 手指:面宽 %1 mm,层厚 %2 mm,每侧 %3 个标记点。</translation>
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
        <translation>手指需要自己的文件夹:请新建或打开一个。</translation>
    </message>
    <message>
        <source>Its untouched picture is missing.</source>
        <translation>缺少未触碰的图像。</translation>
    </message>
    <message>
        <source>Its reference recording is missing: record it bending, untouched.</source>
        <translation>缺少参考录像:请录制它未被触碰时的弯曲过程。</translation>
    </message>
    <message>
        <source>Width and layer are measured with a caliper, dots are counted. All that is known of one finger is kept in one folder.</source>
        <translation>用卡尺测量宽度和层厚,并数出标记点。一个手指的全部信息都保存在一个文件夹里。</translation>
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
        <translation>每次按压都与同样弯曲、未被触碰的手指图像比较。请录制它向各个方向弯曲的过程,然后设为参考。</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>手指</translation>
    </message>
</context>
<context>
    <name>alltact::FrameWords</name>
    <message>
        <source>The finger is pushed from its contact face.</source>
        <translation>手指从接触面受推。</translation>
    </message>
    <message>
        <source>The finger is pushed from its back.</source>
        <translation>手指从背面受推。</translation>
    </message>
    <message>
        <source>The finger is pushed from its upper side.</source>
        <translation>手指从上侧受推。</translation>
    </message>
    <message>
        <source>The finger is pushed from its lower side.</source>
        <translation>手指从下侧受推。</translation>
    </message>
    <message>
        <source>no depth: too dark</source>
        <translation>无深度:过暗</translation>
    </message>
    <message>
        <source>no depth: too bright</source>
        <translation>无深度:过亮</translation>
    </message>
    <message>
        <source>no depth: off the face</source>
        <translation>无深度:不在面上</translation>
    </message>
    <message>
        <source>u %1 px, v %2 px, grey %3</source>
        <translation>u %1 px,v %2 px,灰度 %3</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>深度 %1 mm</translation>
    </message>
    <message>
        <source>Nothing presses on the contact face.</source>
        <translation>接触面上没有受压。</translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s) on the face.</source>
        <translation>
            <numerusform>面上有 %n 处接触。</numerusform>
        </translation>
    </message>
    <message>
        <source>Deepest %1 mm, area %2 mm², volume %3 mm³.</source>
        <translation>最深 %1 mm,面积 %2 mm²,体积 %3 mm³。</translation>
    </message>
    <message>
        <source>Not known without a reference recording.</source>
        <translation>没有参考录像,无法得知。</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>深度,mm</translation>
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
        <translation>相机图像。滚轮或 + 和 - 缩放,0 显示全部,1 为原始大小。拖动或用方向键移动;Shift 加方向键移动探针。</translation>
    </message>
</context>
<context>
    <name>alltact::InspectPane</name>
    <message>
        <source>Difference, mm</source>
        <translation>差值,mm</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>深度,mm</translation>
    </message>
</context>
<context>
    <name>alltact::InspectPlace</name>
    <message>
        <source>&amp;Live finger</source>
        <translation>实时手指(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Video…</source>
        <translation>视频(&amp;V)…</translation>
    </message>
    <message>
        <source>F&amp;older of pictures…</source>
        <translation>图片文件夹(&amp;O)…</translation>
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
        <source>Ours</source>
        <translation>本程序的方法</translation>
    </message>
    <message>
        <source>Ours less the paper&apos;s method</source>
        <translation>本程序的方法减去论文方法</translation>
    </message>
    <message>
        <source>The paper&apos;s method</source>
        <translation>论文方法</translation>
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
        <translation>显示:实时手指</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>显示:%1</translation>
    </message>
    <message>
        <source>The finger is not calibrated yet, so brightness cannot be told as depth.</source>
        <translation>手指尚未标定,无法由亮度得到深度。</translation>
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
        <translation>无法显示;原因见上方。</translation>
    </message>
    <message>
        <source>The recording is being opened.</source>
        <translation>正在打开录像。</translation>
    </message>
    <message>
        <source>No source is open. Choose one above, or open a recording.</source>
        <translation>没有打开的图像源。请在上方选择,或打开一段录像。</translation>
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
        <translation>已保存:%1</translation>
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
</context>
<context>
    <name>alltact::InspectSide</name>
    <message>
        <source>show as %1</source>
        <translation>显示方式:%1</translation>
    </message>
    <message>
        <source>look from: %1</source>
        <translation>视角:%1</translation>
    </message>
    <message>
        <source>compare: %1</source>
        <translation>比较:%1</translation>
    </message>
    <message>
        <source>change the depth colours</source>
        <translation>更改深度颜色</translation>
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
        <source>take the points away</source>
        <translation>移除点</translation>
    </message>
    <message>
        <source>move point A</source>
        <translation>移动 A 点</translation>
    </message>
    <message>
        <source>move point B</source>
        <translation>移动 B 点</translation>
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
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>显示(&amp;W)</translation>
    </message>
    <message>
        <source>in 3D</source>
        <translation>三维</translation>
    </message>
    <message>
        <source>as a height map</source>
        <translation>高度图</translation>
    </message>
    <message>
        <source>3D needs OpenGL 3.2, which this screen does not offer.</source>
        <translation>三维视图需要 OpenGL 3.2,此屏幕不支持。</translation>
    </message>
    <message>
        <source>Look &amp;from</source>
        <translation>视角(&amp;F)</translation>
    </message>
    <message>
        <source>inside, tilted</source>
        <translation>内侧,倾斜</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>outside, tilted</source>
        <translation>外侧,倾斜</translation>
    </message>
    <message>
        <source>the side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Com&amp;pare</source>
        <translation>比较(&amp;P)</translation>
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
        <source>With the source paper&apos;s own formulas, on the same frame and the same finger.</source>
        <translation>使用原论文的公式,同一帧、同一手指。</translation>
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
        <source>&amp;Draw depth</source>
        <translation>绘制深度(&amp;D)</translation>
    </message>
    <message>
        <source> times</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Times that depth is drawn larger than it is</source>
        <translation>深度绘制的放大倍数</translation>
    </message>
    <message>
        <source>&amp;Untouched face as lines</source>
        <translation>以线条显示未受压的面(&amp;U)</translation>
    </message>
    <message>
        <source>C&amp;amera and its axes</source>
        <translation>相机及其坐标轴(&amp;A)</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>剖面</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Point &amp;A</source>
        <translation>A 点(&amp;A)</translation>
    </message>
    <message>
        <source>Point &amp;B</source>
        <translation>B 点(&amp;B)</translation>
    </message>
    <message>
        <source>Point A, u</source>
        <translation>A 点,u</translation>
    </message>
    <message>
        <source>Point A, v</source>
        <translation>A 点,v</translation>
    </message>
    <message>
        <source>Point B, u</source>
        <translation>B 点,u</translation>
    </message>
    <message>
        <source>Point B, v</source>
        <translation>B 点,v</translation>
    </message>
    <message>
        <source>u </source>
        <translation>u </translation>
    </message>
    <message>
        <source>v </source>
        <translation>v </translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Deepest</source>
        <translation>最深</translation>
    </message>
    <message>
        <source>Puts A on the deepest point.</source>
        <translation>将 A 放在最深点。</translation>
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
        <translation>从手指一边到另一边,经过 A 或最深点。</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>纵向</translation>
    </message>
    <message>
        <source>From base to tip, through A or the deepest point.</source>
        <translation>从根部到指尖,经过 A 或最深点。</translation>
    </message>
    <message>
        <source>Measured at the points</source>
        <translation>各点的测量值</translation>
    </message>
    <message>
        <source>Nothing to measure yet.</source>
        <translation>暂无可测量的内容。</translation>
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
        <translation>%1,%2 × %3 px</translation>
    </message>
    <message>
        <source>, %1 mm a pixel</source>
        <translation>,每像素 %1 mm</translation>
    </message>
    <message>
        <source>, focal length %1 px</source>
        <translation>,焦距 %1 px</translation>
    </message>
    <message>
        <source>, behind a window</source>
        <translation>,隔着窗口</translation>
    </message>
    <message>
        <source>Its calibration: %1.</source>
        <translation>其标定:%1。</translation>
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
        <translation>标定板图片的文件夹,或一段录像</translation>
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
        <translation>圆点阵列</translation>
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
        <source> mm</source>
        <translation> mm</translation>
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
        <translation>必须先知道镜头:请选择相机文件或进行测量。</translation>
    </message>
    <message>
        <source>This finger&apos;s camera has %1</source>
        <translation>此手指的相机:%1</translation>
    </message>
    <message>
        <source>The camera has %1</source>
        <translation>相机:%1</translation>
    </message>
    <message>
        <source>A finger measures through its camera&apos;s lens, so the lens comes first. It is measured once for each camera, with ten to twenty pictures of a flat board from all sides.</source>
        <translation>手指通过相机镜头测量,所以先要知道镜头。每台相机只需测量一次:从各个方向拍摄十到二十张平面标定板的图片。</translation>
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
</context>
<context>
    <name>alltact::LivePlace</name>
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
        <translation>圆圈:看得见标记点。虚线菱形:位置为估计值。</translation>
    </message>
    <message>
        <source>Stripes falling to the right: too bright to measure. Stripes falling to the left: too dark.</source>
        <translation>向右下的条纹:过亮,无法测量。向左下的条纹:过暗。</translation>
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
</context>
<context>
    <name>alltact::MainWindow</name>
    <message>
        <source>&amp;Open finger…</source>
        <translation>打开手指(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;New finger…</source>
        <translation>新建手指(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Close finger</source>
        <translation>关闭手指(&amp;C)</translation>
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
        <source>&amp;Live</source>
        <translation>实时(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>录制(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全屏(&amp;F)</translation>
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
        <source>AllTact Studio</source>
        <translation>AllTact Studio</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Recent fingers</source>
        <translation>最近的手指(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Source</source>
        <translation>来源(&amp;S)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Live (Ctrl+1)</source>
        <translation>实时 (Ctrl+1)</translation>
    </message>
    <message>
        <source>Finger:</source>
        <translation>手指:</translation>
    </message>
    <message>
        <source>Source:</source>
        <translation>来源:</translation>
    </message>
    <message>
        <source>Frames delivered</source>
        <translation>收到的帧</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>Age of the picture</source>
        <translation>图像延迟</translation>
    </message>
    <message>
        <source>Time of a frame</source>
        <translation>每帧用时</translation>
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
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
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
        <source>Open a finger&apos;s folder</source>
        <translation>打开手指文件夹</translation>
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
    <message>
        <source>Help</source>
        <translation>帮助</translation>
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

自有源代码采用 BSD-3-Clause 许可;连同所用的库,整个程序采用 GPL 第 3 版许可。</translation>
    </message>
    <message>
        <source>%1 (loading)</source>
        <translation>%1(正在加载)</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1(仿真)</translation>
    </message>
    <message>
        <source>Finger: %1</source>
        <translation>手指:%1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>来源:%1</translation>
    </message>
    <message>
        <source>%1 frames/s, %2 delivered, %3 shown a second</source>
        <translation>%1 帧/秒,已收到 %2 帧,每秒显示 %3 帧</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>丢失 %n 帧</numerusform>
        </translation>
    </message>
    <message>
        <source>picture %1 ms old</source>
        <translation>图像延迟 %1 ms</translation>
    </message>
    <message>
        <source>pictures without times</source>
        <translation>图像没有时间</translation>
    </message>
    <message>
        <source>%1 ms a frame</source>
        <translation>每帧 %1 ms</translation>
    </message>
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
        <source>The source has ended; its last picture is shown.</source>
        <translation>来源已结束;显示的是最后一帧。</translation>
    </message>
    <message>
        <source>&amp;Play it again</source>
        <translation>重新播放(&amp;P)</translation>
    </message>
    <message>
        <source>This finger has no reference recording yet.</source>
        <translation>此手指还没有参考录像。</translation>
    </message>
    <message>
        <source>Record it bending, with nothing on its contact face.</source>
        <translation>请录制它弯曲的过程,接触面上不要有任何东西。</translation>
    </message>
    <message>
        <source>This finger is not calibrated yet, so that no depth is shown.</source>
        <translation>此手指尚未标定,因此不显示深度。</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销:%1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做:%1(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>none</source>
        <comment>source</comment>
        <translation>无</translation>
    </message>
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
        <source>go on with the last session</source>
        <translation>继续上次的会话</translation>
    </message>
    <message>
        <source>none</source>
        <comment>finger</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>标定(&amp;C)</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Calibrate (Ctrl+2)</source>
        <translation>标定 (Ctrl+2)</translation>
    </message>
    <message>
        <source>Record (Ctrl+3)</source>
        <translation>录制 (Ctrl+3)</translation>
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
        <source>&amp;Inspect</source>
        <translation>检视(&amp;I)</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>检视</translation>
    </message>
    <message>
        <source>Inspect (Ctrl+4)</source>
        <translation>检视 (Ctrl+4)</translation>
    </message>
    <message>
        <source>E&amp;xport finger…</source>
        <translation>导出手指(&amp;X)…</translation>
    </message>
    <message>
        <source>recording %1</source>
        <translation>录像 %1</translation>
    </message>
    <message>
        <source>The foot pedal is not heard now.</source>
        <translation>现在收不到脚踏开关的信号。</translation>
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
        <translation>各次按压的误差,最大的在前</translation>
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
            <numerusform>(约剩 %n 秒)</numerusform>
        </translation>
    </message>
    <message>
        <source>The presses have changed since this calibration.</source>
        <translation>此次标定之后按压已有改动。</translation>
    </message>
    <message>
        <source>This finger is calibrated. Calibrating again shows the figures.</source>
        <translation>此手指已标定。重新标定可显示图表。</translation>
    </message>
    <message>
        <source>With one press or more, what every pixel&apos;s darkening means in mm is learnt from the shape of the ball.</source>
        <translation>有一次或多次按压后,由球的形状学得每个像素变暗意味着多少毫米。</translation>
    </message>
    <message>
        <source>What every pixel&apos;s darkening means in mm is learnt from the shape of the ball, with all presses together. Each press is left out once to see how well the others foretell it.</source>
        <translation>每个像素变暗意味着多少毫米,由球的形状和全部按压一起学得。每次按压都会被留出一次,看其余的能预测得多好。</translation>
    </message>
    <message>
        <source>Mapping: %1.</source>
        <translation>映射:%1。</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>映射</translation>
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
        <translation>尚无映射:请用钢球按压标定</translation>
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
        <translation>亮度差 x(无单位)</translation>
    </message>
    <message>
        <source>Brightness difference x (share of the untouched brightness)</source>
        <translation>亮度差 x(占未触碰亮度的比例)</translation>
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
        <translation>鳍条手指:形状由面的边缘得出</translation>
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
        <translation>用卡尺测量宽度和层厚,并数出标记点。相机文件来自镜头标定,即“标定”的第一步。</translation>
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
        <translation>把轮廓的中心或边缘拖到球上。方向键移动十分之一像素,Page Up 和 Page Down 改变大小,加 Shift 为一个像素。Ctrl 加方向键移动画面;滚轮缩放,在边缘上则改变大小。</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px; ball at x %4, y %5, z %6 mm</source>
        <translation>中心 u %1 px,v %2 px,半径 %3 px;球在 x %4,y %5,z %6 mm</translation>
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
    <name>alltact::PicturePanel</name>
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
        <translation>无法打开来源;原因见上方。</translation>
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
        <translation>指向一个像素,或按 Shift 加方向键。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
</context>
<context>
    <name>alltact::PressDesk</name>
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
        <translation>已有同名的按压:%1。</translation>
    </message>
</context>
<context>
    <name>alltact::PressErrorPlot</name>
    <message>
        <source>Error of every press, worst first</source>
        <translation>各次按压的误差,最大的在前</translation>
    </message>
    <message numerus="yes">
        <source>The worst of %n press(es) is %1 with %2 mm.</source>
        <translation>
            <numerusform>%n 次按压中最差的是 %1,%2 mm。</numerusform>
        </translation>
    </message>
    <message>
        <source>No presses yet</source>
        <translation>还没有按压</translation>
    </message>
    <message>
        <source>residual: the mapping knows this press</source>
        <translation>残差:映射用过此按压</translation>
    </message>
    <message>
        <source>left out: the mapping was made without it</source>
        <translation>留出:映射未使用它</translation>
    </message>
    <message numerus="yes">
        <source>Mean depth error inside the contact (mm); %n better press(es) not shown</source>
        <translation>
            <numerusform>接触内的平均深度误差 (mm);另有 %n 次较好的按压未显示</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean depth error inside the contact (mm)</source>
        <translation>接触内的平均深度误差 (mm)</translation>
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
        <translation>已取出:%1</translation>
    </message>
    <message>
        <source>%1 mm deep, error %2 mm</source>
        <translation>深 %1 mm,误差 %2 mm</translation>
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
        <translation>移除按压及其图片(可撤销)</translation>
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
        <translation>拍摄按压(空格)(&amp;T)</translation>
    </message>
    <message>
        <source>By &amp;itself when it holds still</source>
        <translation>静止时自动拍摄(&amp;I)</translation>
    </message>
    <message>
        <source>Takes a press as soon as a contact holds still for half a second; both hands stay free</source>
        <translation>接触静止半秒后自动拍摄;双手不必离开</translation>
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
        <translation>黄色:球的轮廓,虚线为程序找到的,实线为手动放置的。蓝色:球与未触碰面相交之处,大致是暗斑。</translation>
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
        <translation>请先拍摄一次按压;在不同位置拍六次为好。</translation>
    </message>
    <message>
        <source>In no press a ball was found yet.</source>
        <translation>还没有在任何按压中找到球。</translation>
    </message>
    <message>
        <source>There is no live picture: choose a source.</source>
        <translation>没有实时画面:请选择来源。</translation>
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
        <source>%1 is taken.</source>
        <translation>已拍摄 %1。</translation>
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
        <translation>请尝试:%1。</translation>
    </message>
    <message>
        <source>Or drag the outline onto the ball.</source>
        <translation>或者把轮廓拖到球上。</translation>
    </message>
    <message>
        <source>As it lies now it is pressed in by %1 mm.</source>
        <translation>按现在的位置,球压入 %1 mm。</translation>
    </message>
    <message>
        <source>As it lies now it does not touch the face.</source>
        <translation>按现在的位置,球没有碰到面。</translation>
    </message>
    <message>
        <source>Chosen &amp;press</source>
        <translation>所选按压(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Put back</source>
        <translation>放回(&amp;P)</translation>
    </message>
    <message>
        <source>Take &amp;out</source>
        <translation>取出(&amp;O)</translation>
    </message>
    <message>
        <source>A press that is taken out stays with the finger and is not used</source>
        <translation>取出的按压仍保存在手指中,但不使用</translation>
    </message>
    <message>
        <source>The picture is being read.</source>
        <translation>正在读取图片。</translation>
    </message>
    <message>
        <source>Centre u %1 px, v %2 px, radius %3 px, %4 mm before the camera</source>
        <translation>中心 u %1 px,v %2 px,半径 %3 px,距相机 %4 mm</translation>
    </message>
    <message>
        <source>No ball is drawn here.</source>
        <translation>这里没有画球。</translation>
    </message>
    <message>
        <source>No press yet. Press the ball in at different places and depths, base, middle and tip.</source>
        <translation>还没有按压。请在不同位置以不同深度压入球:根部、中部和指尖。</translation>
    </message>
    <message numerus="yes">
        <source>%n press(es), </source>
        <translation>
            <numerusform>%n 次按压,</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n usable</source>
        <translation>
            <numerusform>%n 次可用</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>alltact::ProblemList</name>
    <message>
        <source>Try: %1</source>
        <translation>建议:%1</translation>
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
</context>
<context>
    <name>alltact::ReadingWords</name>
    <message>
        <source>no depth: too dark</source>
        <translation>无深度:过暗</translation>
    </message>
    <message>
        <source>no depth: too bright</source>
        <translation>无深度:过亮</translation>
    </message>
    <message>
        <source>no depth: near the face&apos;s edge</source>
        <translation>无深度:靠近面的边缘</translation>
    </message>
    <message>
        <source>depth %1 ± %2 mm</source>
        <translation>深度 %1 ± %2 mm</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>深度 %1 mm</translation>
    </message>
    <message>
        <source> (beyond what was calibrated)</source>
        <translation>(超出标定范围)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: off the face</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;:不在面上</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: x %2, y %3, z %4 mm</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;:x %2,y %3,z %4 mm</translation>
    </message>
    <message>
        <source>&lt;b&gt;A to B&lt;/b&gt;: %1 mm straight, %2 mm over the face</source>
        <translation>&lt;b&gt;A 到 B&lt;/b&gt;:直线 %1 mm,沿面 %2 mm</translation>
    </message>
    <message>
        <source>by x %1, y %2, z %3 mm</source>
        <translation>x %1,y %2,z %3 mm</translation>
    </message>
    <message>
        <source>Deepest %1 mm; contact at x %2, y %3, z %4 mm.</source>
        <translation>最深 %1 mm;接触位置 x %2,y %3,z %4 mm。</translation>
    </message>
    <message>
        <source>Nothing presses on the face.</source>
        <translation>面上没有受压。</translation>
    </message>
    <message>
        <source>Click on the face for point A, with the right button for point B.</source>
        <translation>在面上单击设置 A 点,右键单击设置 B 点。</translation>
    </message>
</context>
<context>
    <name>alltact::RecordPlace</name>
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
        <translation>停止安装;不作任何更改。</translation>
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
        <source>The markers have to be seen to tell how it bends.</source>
        <translation>必须看得见标记点才能判断弯曲。</translation>
    </message>
    <message>
        <source>All directions are reached.</source>
        <translation>所有方向都已达到。</translation>
    </message>
    <message>
        <source>Still missing: %1.</source>
        <translation>还缺少:%1。</translation>
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
        <translation>请先打开来源:相机或仿真手指。</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>停止录制(&amp;R)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Recording&lt;/b&gt; %1 min&lt;br&gt;%2, %3, %4 GB</source>
        <translation>&lt;b&gt;正在录制&lt;/b&gt; %1 分钟&lt;br&gt;%2,%3,%4 GB</translation>
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
        <translation>剩余空间:%1 GB</translation>
    </message>
    <message numerus="yes">
        <source>, room for about %n minute(s)</source>
        <translation>
            <numerusform>,约可录 %n 分钟</numerusform>
        </translation>
    </message>
    <message>
        <source>Open the finger that was recorded first.</source>
        <translation>请先打开被录制的手指。</translation>
    </message>
    <message>
        <source>A flat sensor has one untouched picture instead of a recording.</source>
        <translation>平面传感器只需一张未接触的图片,不需要录像。</translation>
    </message>
    <message>
        <source>A recording is under way.</source>
        <translation>正在录制。</translation>
    </message>
    <message>
        <source>%1: %2, %3 min</source>
        <translation>%1:%2,%3 分钟</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) were lost because this computer or its disk was too slow.</source>
        <translation>
            <numerusform>由于本机或磁盘太慢,丢失了 %n 帧。</numerusform>
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
    <message numerus="yes">
        <source>The contact face was touched in %n frame(s).</source>
        <translation>
            <numerusform>有 %n 帧接触面被触碰。</numerusform>
        </translation>
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
            <numerusform>已安装:%n 帧中有 %1 帧进入参考。</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out, with the reason:</source>
        <translation>被舍弃的帧及原因:</translation>
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
        <source>The contact face is touched.</source>
        <translation>接触面被触碰。</translation>
    </message>
    <message>
        <source>Keep it free: bend the finger at its tip, its sides or its back.</source>
        <translation>请保持其空闲:从指尖、侧面或背面弯曲手指。</translation>
    </message>
    <message>
        <source>Little space is left on the disk.</source>
        <translation>磁盘剩余空间不足。</translation>
    </message>
    <message>
        <source>Choose a file on another disk, or make room.</source>
        <translation>请选择其他磁盘上的文件,或清理空间。</translation>
    </message>
    <message>
        <source>Start &amp;recording</source>
        <translation>开始录制(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>What it leaves open: half of the references made from it are off by less than %1 mm, 95 % by less than %2 mm.</source>
        <translation>剩余误差:由此得到的参考,一半偏差小于 %1 mm,95 % 小于 %2 mm。</translation>
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
</context>
<context>
    <name>alltact::SaveBar</name>
    <message>
        <source>Mesh, PLY</source>
        <translation>网格,PLY</translation>
    </message>
    <message>
        <source>Mesh, VTP (VTK)</source>
        <translation>网格,VTP (VTK)</translation>
    </message>
    <message>
        <source>Mesh, STL</source>
        <translation>网格,STL</translation>
    </message>
    <message>
        <source>Mesh, glTF</source>
        <translation>网格,glTF</translation>
    </message>
    <message>
        <source>Picture, PNG</source>
        <translation>图片,PNG</translation>
    </message>
    <message>
        <source>Video in 3D, MKV</source>
        <translation>三维视频,MKV</translation>
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
        <source>ours</source>
        <translation>本程序</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>论文</translation>
    </message>
    <message>
        <source>From A over the face (mm)</source>
        <translation>从 A 沿面的距离 (mm)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>深度 (mm)</translation>
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
    <name>alltact::StartPanel</name>
    <message>
        <source>What shall be shown?</source>
        <translation>要显示什么?</translation>
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
        <translation>继续:%1(&amp;G)</translation>
    </message>
    <message>
        <source>No camera is plugged in.</source>
        <translation>未连接相机。</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
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
        <source>%1 %2: %3</source>
        <translation>%1 %2:%3</translation>
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
</context>
<context>
    <name>alltact::VerdictPage</name>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Usable for contact and its place</source>
        <translation>可用于判断接触及其位置</translation>
    </message>
    <message>
        <source>Unproven</source>
        <translation>未经证实</translation>
    </message>
    <message>
        <source>Not fit to measure with</source>
        <translation>不适合测量</translation>
    </message>
    <message>
        <source>What to press next</source>
        <translation>下一次按压何处</translation>
    </message>
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
        <source>The presses have changed since: calibrate again.</source>
        <translation>此后按压已有改动:请重新标定。</translation>
    </message>
    <message>
        <source>The report is being written.</source>
        <translation>正在写报告。</translation>
    </message>
    <message>
        <source>By zone of the face: %1.</source>
        <translation>按面上的区域:%1。</translation>
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
        <source>None.</source>
        <translation>无。</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
</context>
</TS>
