<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
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
        <source>A camera's exposure, gain, white balance and focus stand here. This source is no camera.</source>
        <translation>相机的曝光、增益、白平衡和对焦显示在这里。当前来源不是相机。</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
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
    <name>alltact::FaceView</name>
    <message>
        <source>Face in 3D</source>
        <translation>接触面三维视图</translation>
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
    <name>alltact::ImageView</name>
    <message>
        <source>Picture</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>The camera's picture. The wheel or + and - zoom, 0 shows all of it, 1 its own size. Drag or use the arrow keys to move it; Shift and the arrow keys move the probe.</source>
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
        <source>Ours less the paper's method</source>
        <translation>本程序的方法减去论文方法</translation>
    </message>
    <message>
        <source>The paper's method</source>
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
        <source>With the source paper's own formulas, on the same frame and the same finger.</source>
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
        <source>Record (Ctrl+2)</source>
        <translation>录制 (Ctrl+2)</translation>
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
        <source>Open a finger's folder</source>
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
        <source>Calibrate it with ball presses (alltact calibrate).</source>
        <translation>用钢球按压进行标定(alltact calibrate)。</translation>
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
        <source>&amp;Inspect</source>
        <translation>检视(&amp;I)</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>检视</translation>
    </message>
    <message>
        <source>Inspect (Ctrl+3)</source>
        <translation>检视 (Ctrl+3)</translation>
    </message>
</context>
<context>
    <name>alltact::NewFingerDialog</name>
    <message>
        <source>New finger</source>
        <translation>新建手指</translation>
    </message>
    <message>
        <source>Measure width and layer with a caliper, and count the dots. The camera file comes from the lens calibration (alltact lens).</source>
        <translation>用卡尺测量宽度和层厚,并数出标记点。相机文件来自镜头标定(alltact lens)。</translation>
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
        <source>Fin Ray finger: its shape is read from the face's edges</source>
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
        <source>A lens calibration makes one: alltact lens.</source>
        <translation>镜头标定会生成它:alltact lens。</translation>
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
        <source>no depth: near the face's edge</source>
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
        <source>&amp;Install as this finger's reference</source>
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
</TS>
