<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>Begin a new, empty project.</source>
        <translation>开始一个新的空项目。</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Import a part…</source>
        <translation>导入零件(&amp;I)…</translation>
    </message>
    <message>
        <source>Sample &amp;part</source>
        <translation>示例零件(&amp;P)</translation>
    </message>
    <message>
        <source>Import the part that Burin is shipped with.</source>
        <translation>导入 Burin 附带的零件。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation>保存项目。</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the project under another name and continue with it.</source>
        <translation>以另一名称保存项目，并在其中继续工作。</translation>
    </message>
    <message>
        <source>&amp;Export the program…</source>
        <translation>导出程序(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the program that passed its check to a file.</source>
        <translation>将通过检查的程序写入文件。</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Undo the last change.</source>
        <translation>撤销上一次更改。</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Redo the change that was undone last.</source>
        <translation>重做上一次撤销的更改。</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>首选项(&amp;P)…</translation>
    </message>
    <message>
        <source>Unit, theme and language.</source>
        <translation>单位、主题和语言。</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>Show everything.</source>
        <translation>显示全部内容。</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>等轴测(&amp;I)</translation>
    </message>
    <message>
        <source>Look from a corner.</source>
        <translation>从一角观察。</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>俯视(&amp;T)</translation>
    </message>
    <message>
        <source>Look along the tool.</source>
        <translation>沿刀具方向观察。</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>仰视(&amp;B)</translation>
    </message>
    <message>
        <source>Look from below.</source>
        <translation>从下方观察。</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>前视(&amp;R)</translation>
    </message>
    <message>
        <source>Look from the front.</source>
        <translation>从前方观察。</translation>
    </message>
    <message>
        <source>B&amp;ack</source>
        <translation>后视(&amp;A)</translation>
    </message>
    <message>
        <source>Look from the back.</source>
        <translation>从后方观察。</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左视(&amp;L)</translation>
    </message>
    <message>
        <source>Look from the left.</source>
        <translation>从左侧观察。</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>右视(&amp;G)</translation>
    </message>
    <message>
        <source>Look from the right.</source>
        <translation>从右侧观察。</translation>
    </message>
    <message>
        <source>&amp;Part</source>
        <translation>零件(&amp;P)</translation>
    </message>
    <message>
        <source>Draw the part together with the workpiece.</source>
        <translation>与工件一起显示零件。</translation>
    </message>
    <message>
        <source>&amp;Workpiece</source>
        <translation>工件(&amp;W)</translation>
    </message>
    <message>
        <source>Draw the workpiece.</source>
        <translation>显示工件。</translation>
    </message>
    <message>
        <source>T&amp;ool</source>
        <translation>刀具(&amp;O)</translation>
    </message>
    <message>
        <source>Draw the tool.</source>
        <translation>显示刀具。</translation>
    </message>
    <message>
        <source>Pat&amp;h</source>
        <translation>刀路(&amp;H)</translation>
    </message>
    <message>
        <source>Draw the edited path.</source>
        <translation>显示编辑后的刀路。</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>下一步(&amp;N)</translation>
    </message>
    <message>
        <source>Open the next step of the job.</source>
        <translation>打开作业的下一步。</translation>
    </message>
    <message>
        <source>Pre&amp;vious step</source>
        <translation>上一步(&amp;V)</translation>
    </message>
    <message>
        <source>Open the step of the job before this one.</source>
        <translation>打开作业的上一步。</translation>
    </message>
    <message>
        <source>&amp;Embed the part</source>
        <translation>嵌入零件(&amp;E)</translation>
    </message>
    <message>
        <source>Embed the part in its stock; this makes the workpiece.</source>
        <translation>将零件嵌入其毛坯，由此生成工件。</translation>
    </message>
    <message>
        <source>&amp;Show me</source>
        <translation>演示(&amp;S)</translation>
    </message>
    <message>
        <source>Watch a virtual operator mill this part.</source>
        <translation>观看虚拟操作员铣削此零件。</translation>
    </message>
    <message>
        <source>S&amp;top the virtual operator</source>
        <translation>停止虚拟操作员(&amp;T)</translation>
    </message>
    <message>
        <source>Stop; the recording is kept.</source>
        <translation>停止；已录制的内容会保留。</translation>
    </message>
    <message>
        <source>&amp;New path</source>
        <translation>新建刀路(&amp;N)</translation>
    </message>
    <message>
        <source>Make a path from the takes, with the standard edits.</source>
        <translation>用标准编辑步骤从录制生成刀路。</translation>
    </message>
    <message>
        <source>&amp;Update path</source>
        <translation>更新刀路(&amp;U)</translation>
    </message>
    <message>
        <source>Apply the edits to the takes again.</source>
        <translation>对录制重新应用编辑步骤。</translation>
    </message>
    <message>
        <source>&amp;Post and check</source>
        <translation>后处理并检查(&amp;P)</translation>
    </message>
    <message>
        <source>Make the program, read it back and check it.</source>
        <translation>生成程序，回读并检查。</translation>
    </message>
    <message>
        <source>&amp;Welcome page</source>
        <translation>欢迎页(&amp;W)</translation>
    </message>
    <message>
        <source>Show how to begin.</source>
        <translation>显示如何开始。</translation>
    </message>
    <message>
        <source>&amp;About Burin</source>
        <translation>关于 Burin(&amp;A)</translation>
    </message>
    <message>
        <source>Version, licence and sources.</source>
        <translation>版本、许可证和来源。</translation>
    </message>
    <message>
        <source>Quit Burin.</source>
        <translation>退出 Burin。</translation>
    </message>
    <message>
        <source>&amp;Guides on</source>
        <translation>启用导向(&amp;G)</translation>
    </message>
    <message>
        <source>Switch all guides of the hand on or off.</source>
        <translation>打开或关闭手部的全部导向。</translation>
    </message>
    <message>
        <source>Guide along the nearest &amp;edge</source>
        <translation>沿最近的边导向(&amp;E)</translation>
    </message>
    <message>
        <source>Lead the hand along the edge of the part that is nearest to the tool.</source>
        <translation>引导手沿零件上离刀具最近的边移动。</translation>
    </message>
    <message>
        <source>Level &amp;above</source>
        <translation>上一层(&amp;A)</translation>
    </message>
    <message>
        <source>The guide takes the next level above, or ends the pass.</source>
        <translation>导向转到上方的下一层，或结束该走刀。</translation>
    </message>
    <message>
        <source>Level &amp;below</source>
        <translation>下一层(&amp;B)</translation>
    </message>
    <message>
        <source>The guide takes the next level below, or ends the pass.</source>
        <translation>导向转到下方的下一层，或结束该走刀。</translation>
    </message>
    <message>
        <source>&amp;Clutch</source>
        <translation>离合(&amp;C)</translation>
    </message>
    <message>
        <source>The hand moves, the tool stays.</source>
        <translation>手移动，刀具不动。</translation>
    </message>
    <message>
        <source>Re&amp;centre</source>
        <translation>回中(&amp;C)</translation>
    </message>
    <message>
        <source>Brings the hand back to the centre of the device&apos;s workspace while you work.</source>
        <translation>在工作过程中将手带回设备工作空间的中心。</translation>
    </message>
    <message>
        <source>A&amp;lign the hand with the view</source>
        <translation>手与视图对齐(&amp;L)</translation>
    </message>
    <message>
        <source>A hand movement to the right moves the tool to the right in the view.</source>
        <translation>手向右移动时，刀具在视图中向右移动。</translation>
    </message>
    <message>
        <source>G&amp;uides</source>
        <translation>导向(&amp;U)</translation>
    </message>
    <message>
        <source>Draw the guides of the hand that are on.</source>
        <translation>显示手部已启用的导向。</translation>
    </message>
    <message>
        <source>Fixture from a &amp;file…</source>
        <translation>从文件读取夹具(&amp;F)…</translation>
    </message>
    <message>
        <source>Tool a&amp;xis along the view</source>
        <translation>刀轴沿视图方向(&amp;X)</translation>
    </message>
    <message>
        <source>Sets the tool axis to the view direction (3+2 milling).</source>
        <translation>将刀轴设为视图方向（3+2 铣削）。</translation>
    </message>
    <message>
        <source>Fi&amp;ner hand</source>
        <translation>手动比例调细(&amp;N)</translation>
    </message>
    <message>
        <source>Smaller tool movement for the same hand movement.</source>
        <translation>手的移动量相同，刀具移动更小。</translation>
    </message>
    <message>
        <source>C&amp;oarser hand</source>
        <translation>手动比例调粗(&amp;O)</translation>
    </message>
    <message>
        <source>Larger tool movement for the same hand movement.</source>
        <translation>手的移动量相同，刀具移动更大。</translation>
    </message>
    <message>
        <source>The hand sets the spee&amp;d</source>
        <translation>由手控制速度(&amp;D)</translation>
    </message>
    <message>
        <source>A stylus without motors sets the tool&apos;s speed, not its position.</source>
        <translation>不带电机的触笔控制刀具的速度，而不是位置。</translation>
    </message>
    <message>
        <source>&amp;Draw instead</source>
        <translation>改为手绘(&amp;D)</translation>
    </message>
    <message>
        <source>Draw a stroke in the view that replaces the selected part of the path.</source>
        <translation>在视图中画一个笔画，替换刀路中选定的部分。</translation>
    </message>
    <message>
        <source>&amp;Find in the program</source>
        <translation>在程序中查找(&amp;F)</translation>
    </message>
    <message>
        <source>Look for a text in the program.</source>
        <translation>在程序中查找文本。</translation>
    </message>
    <message>
        <source>&amp;Override the check…</source>
        <translation>忽略检查结果(&amp;O)…</translation>
    </message>
    <message>
        <source>Export a program that failed its check; you must state a reason.</source>
        <translation>导出未通过检查的程序；必须说明理由。</translation>
    </message>
    <message>
        <source>Paths of other tool&amp;s</source>
        <translation>其他刀具的刀路(&amp;S)</translation>
    </message>
    <message>
        <source>Draw the paths of the job&apos;s other tools.</source>
        <translation>显示作业中其他刀具的刀路。</translation>
    </message>
    <message>
        <source>Draw for an ed&amp;it</source>
        <translation>为编辑步骤绘制(&amp;I)</translation>
    </message>
    <message>
        <source>Draw the area, the guide or the mirror plane of the last edit that has one.</source>
        <translation>绘制最后一个带有区域、导向或镜像平面的编辑步骤的相应内容。</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>按键和鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>All keyboard shortcuts and mouse actions.</source>
        <translation>所有键盘快捷键和鼠标操作。</translation>
    </message>
    <message>
        <source>&amp;Mill</source>
        <translation>铣削(&amp;M)</translation>
    </message>
    <message>
        <source>Start or stop milling. Everything that is cut is recorded.</source>
        <translation>开始或停止铣削。所有切削都会被录制。</translation>
    </message>
    <message>
        <source>Ras&amp;ter</source>
        <translation>行切(&amp;T)</translation>
    </message>
    <message>
        <source>Drag a rectangle; it is milled in rows at the step-over.</source>
        <translation>拖出一个矩形；按行距逐行铣削。</translation>
    </message>
    <message>
        <source>Repeat &amp;lower</source>
        <translation>向下重复(&amp;L)</translation>
    </message>
    <message>
        <source>Repeat the last stroke, lower by the depth of cut.</source>
        <translation>重复上一个笔画，下移一个切深。</translation>
    </message>
    <message>
        <source>Repeat beside, le&amp;ft</source>
        <translation>向左侧重复(&amp;F)</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the left of its direction.</source>
        <translation>重复上一个笔画，沿其方向左移一个行距。</translation>
    </message>
    <message>
        <source>Repeat beside, ri&amp;ght</source>
        <translation>向右侧重复(&amp;G)</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the right of its direction.</source>
        <translation>重复上一个笔画，沿其方向右移一个行距。</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>平行投影(&amp;J)</translation>
    </message>
    <message>
        <source>Parallel edges stay parallel in every view. Views along an axis always are so.</source>
        <translation>平行的边在任何视图中都保持平行。沿轴的视图始终如此。</translation>
    </message>
    <message>
        <source>Transpare&amp;nt workpiece</source>
        <translation>透明工件(&amp;N)</translation>
    </message>
    <message>
        <source>Show the part through the workpiece.</source>
        <translation>透过工件显示零件。</translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation>剖切(&amp;E)</translation>
    </message>
    <message>
        <source>Section the part and the workpiece in the view.</source>
        <translation>在视图中剖切零件和工件。</translation>
    </message>
    <message>
        <source>Fl&amp;ip</source>
        <translation>翻转(&amp;I)</translation>
    </message>
    <message>
        <source>Show the other side of the section plane.</source>
        <translation>显示剖切面的另一侧。</translation>
    </message>
    <message>
        <source>&amp;Text next to the view</source>
        <translation>文本显示在视图旁(&amp;T)</translation>
    </message>
    <message>
        <source>Show the program&apos;s text and findings next to the view instead of in the panel.</source>
        <translation>在视图旁而不是面板中显示程序文本和问题。</translation>
    </message>
    <message>
        <source>&amp;Restart at the selected line…</source>
        <translation>从选定行重新开始(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Machines…</source>
        <translation>机床(&amp;M)…</translation>
    </message>
    <message>
        <source>Look at the machines; copy, change and delete your own.</source>
        <translation>查看机床；复制、更改和删除自己的机床。</translation>
    </message>
    <message>
        <source>Export the rest of the program from the selected line, with a safe re-entry into the cut, for example after tool breakage.</source>
        <translation>从选定行起导出程序的剩余部分，并安全地重新切入，例如在断刀之后。</translation>
    </message>
    <message>
        <source>Export the &amp;workpiece…</source>
        <translation>导出工件(&amp;W)…</translation>
    </message>
    <message>
        <source>Write the workpiece as a surface (STL, PLY, 3MF) or as voxels.</source>
        <translation>将工件写为曲面（STL、PLY、3MF）或体素。</translation>
    </message>
    <message>
        <source>Stoc&amp;k from a file…</source>
        <translation>从文件读取毛坯(&amp;K)…</translation>
    </message>
    <message>
        <source>Read the stock from a volume file, a voxel array (a scan) or a model.</source>
        <translation>从体数据文件、体素数组（扫描）或模型读取毛坯。</translation>
    </message>
    <message>
        <source>Mate&amp;rials…</source>
        <translation>材料(&amp;R)…</translation>
    </message>
    <message>
        <source>Look at, copy, change, add and calibrate materials.</source>
        <translation>查看、复制、更改、添加和标定材料。</translation>
    </message>
    <message>
        <source>Too&amp;l from models…</source>
        <translation>由模型生成刀具(&amp;L)…</translation>
    </message>
    <message>
        <source>Make a tool of models of its flutes and its shank: a form tool, a worn cutter.</source>
        <translation>由刃部和刀杆的模型生成刀具：成形刀、磨损的铣刀。</translation>
    </message>
    <message>
        <source>&amp;Tools…</source>
        <translation>刀具(&amp;T)…</translation>
    </message>
    <message>
        <source>Look at the tools; copy, change, add and delete your own.</source>
        <translation>查看刀具；复制、更改、添加和删除自己的刀具。</translation>
    </message>
    <message>
        <source>Read a part from a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF).</source>
        <translation>从 CAD 文件（STEP、IGES、BREP）或网格（STL、3MF、OBJ、PLY、AMF、OFF）读取零件。</translation>
    </message>
    <message>
        <source>&amp;Add a setup…</source>
        <translation>添加装夹(&amp;A)…</translation>
    </message>
    <message>
        <source>Add a setup for another side of the part. Its stock is the workpiece that this setup leaves.</source>
        <translation>为零件的另一面添加装夹。其毛坯是当前装夹加工后留下的工件。</translation>
    </message>
    <message>
        <source>&amp;Next setup</source>
        <translation>下一个装夹(&amp;N)</translation>
    </message>
    <message>
        <source>Switch to the next setup.</source>
        <translation>切换到下一个装夹。</translation>
    </message>
    <message>
        <source>Pre&amp;vious setup</source>
        <translation>上一个装夹(&amp;V)</translation>
    </message>
    <message>
        <source>Switch to the previous setup.</source>
        <translation>切换到上一个装夹。</translation>
    </message>
    <message>
        <source>Orient a face &amp;down</source>
        <translation>使一个面朝下(&amp;D)</translation>
    </message>
    <message>
        <source>Click a face of the part in the view. The part is rotated so that this face points down.</source>
        <translation>在视图中单击零件的一个面。零件将旋转，使该面朝下。</translation>
    </message>
    <message>
        <source>Rotate by 90° about &amp;X</source>
        <translation>绕 X 旋转 90°(&amp;X)</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about X, through its centre.</source>
        <translation>将零件绕过其中心的 X 向轴线旋转 90°。</translation>
    </message>
    <message>
        <source>Rotate by 90° about &amp;Y</source>
        <translation>绕 Y 旋转 90°(&amp;Y)</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about Y, through its centre.</source>
        <translation>将零件绕过其中心的 Y 向轴线旋转 90°。</translation>
    </message>
    <message>
        <source>Rotate by 90° about &amp;Z</source>
        <translation>绕 Z 旋转 90°(&amp;Z)</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about Z, through its centre.</source>
        <translation>将零件绕过其中心的 Z 向轴线旋转 90°。</translation>
    </message>
    <message>
        <source>Import a fixture in the coordinates of the setup; the tool keeps clear of it.</source>
        <translation>按装夹坐标导入夹具；刀具会避开它。</translation>
    </message>
    <message>
        <source>&amp;Pick program zero</source>
        <translation>点选程序零点(&amp;P)</translation>
    </message>
    <message>
        <source>Click a vertex, an edge or a circle of the part, or a corner of the stock.</source>
        <translation>单击零件的顶点、边或圆，或毛坯的角点。</translation>
    </message>
    <message>
        <source>Export the setup s&amp;heet…</source>
        <translation>导出装夹单(&amp;H)…</translation>
    </message>
    <message>
        <source>Write a page for the machine: pictures, zero, fixtures, tools, times, findings.</source>
        <translation>写出供机床使用的页面：图片、零点、夹具、刀具、时间、问题。</translation>
    </message>
    <message>
        <source>&amp;Touch off program zero</source>
        <translation>对刀确定程序零点(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Compute a pass…</source>
        <translation>计算走刀(&amp;C)…</translation>
    </message>
    <message>
        <source>Paint the area of the next pass on the part; Shift erases.</source>
        <translation>在零件上涂画下一次走刀的区域；按 Shift 擦除。</translation>
    </message>
    <message>
        <source>Draw round the area of the next pass; Shift erases.</source>
        <translation>圈出下一次走刀的区域；按 Shift 擦除。</translation>
    </message>
    <message>
        <source>Pick &amp;faces as the area</source>
        <translation>选择面作为区域(&amp;F)</translation>
    </message>
    <message>
        <source>Click faces of the part for the next pass; Shift removes them.</source>
        <translation>单击零件的面用于下一次走刀；按 Shift 移除。</translation>
    </message>
    <message>
        <source>Clea&amp;r the area</source>
        <translation>清除区域(&amp;R)</translation>
    </message>
    <message>
        <source>The next pass goes over the whole part again.</source>
        <translation>下一次走刀恢复为加工整个零件。</translation>
    </message>
    <message>
        <source>Paint an area with the &amp;brush</source>
        <translation>用画笔涂画区域(&amp;B)</translation>
    </message>
    <message>
        <source>Draw an area with the &amp;lasso</source>
        <translation>用套索圈出区域(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Measure the passes</source>
        <translation>测量走刀(&amp;M)</translation>
    </message>
    <message>
        <source>Length, time, share of air and engagement of each pass, and the stock that it leaves.</source>
        <translation>每次走刀的长度、时间、空切比例和吃刀量，以及留下的残料。</translation>
    </message>
    <message>
        <source>De&amp;vices…</source>
        <translation>设备(&amp;V)…</translation>
    </message>
    <message>
        <source>List the styluses that were found, and test them before milling.</source>
        <translation>列出找到的触笔，并在铣削前测试。</translation>
    </message>
    <message>
        <source>&amp;Update the part</source>
        <translation>更新零件(&amp;U)</translation>
    </message>
    <message>
        <source>Read the part again after it was changed in the CAD system. Setups, roles, materials, recordings and paths stay.</source>
        <translation>零件在 CAD 系统中更改后重新读取。装夹、角色、材料、录制和刀路保留。</translation>
    </message>
    <message>
        <source>Time&amp;line</source>
        <translation>时间轴(&amp;L)</translation>
    </message>
    <message>
        <source>Show the takes along their time below the view.</source>
        <translation>在视图下方按时间显示录制。</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Show the workpiece as it is now.</source>
        <translation>显示工件的当前状态。</translation>
    </message>
    <message>
        <source>P&amp;unch in</source>
        <translation>插录(&amp;U)</translation>
    </message>
    <message>
        <source>Add a mar&amp;ker…</source>
        <translation>添加标记(&amp;K)…</translation>
    </message>
    <message>
        <source>Open a project, or a program to check and play.</source>
        <translation>打开项目，或打开程序进行检查和播放。</translation>
    </message>
    <message>
        <source>Play the takes, or the program, from the time shown; the workpiece follows.</source>
        <translation>从所示时间起播放录制或程序；工件随之变化。</translation>
    </message>
    <message>
        <source>Back to the &amp;current state</source>
        <translation>返回当前状态(&amp;C)</translation>
    </message>
    <message>
        <source>Continue milling from the time shown. Everything recorded after it is switched off, and can be switched on again.</source>
        <translation>从所示时间继续铣削。此后录制的内容全部关闭，可以重新打开。</translation>
    </message>
    <message>
        <source>Set a named marker at the time shown on the timeline.</source>
        <translation>在时间轴所示时间设置一个命名标记。</translation>
    </message>
    <message>
        <source>Next path &amp;colours</source>
        <translation>下一种刀路着色(&amp;C)</translation>
    </message>
    <message>
        <source>Colour the path by its feed, spindle speed, height, removal rate, force or deviation from the recording, in turn.</source>
        <translation>依次按进给、主轴转速、高度、材料去除率、力或与录制的偏差为刀路着色。</translation>
    </message>
    <message>
        <source>Path from a pro&amp;gram…</source>
        <translation>由程序生成刀路(&amp;G)…</translation>
    </message>
    <message>
        <source>Edit a program of another system (G-code or APT/CL) as a path: its moves, feeds and speeds; Burin links them anew.</source>
        <translation>将其他系统的程序（G 代码或 APT/CL）作为刀路编辑：保留其移动、进给和转速；由 Burin 重新连接。</translation>
    </message>
    <message>
        <source>H&amp;istory</source>
        <translation>历史记录(&amp;I)</translation>
    </message>
    <message>
        <source>Show all changes next to the view; a click goes back to one, or forward again.</source>
        <translation>在视图旁显示所有更改；单击可退回到某一更改，或再次前进。</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>Reset the &amp;window layout</source>
        <translation>重置窗口布局(&amp;W)</translation>
    </message>
    <message>
        <source>Put docks and panels back to where they were at first.</source>
        <translation>将停靠窗口和面板放回最初的位置。</translation>
    </message>
    <message>
        <source>Export a p&amp;icture…</source>
        <translation>导出图片(&amp;I)…</translation>
    </message>
    <message>
        <source>Write what the view shows to a PNG file.</source>
        <translation>将视图所示内容写入 PNG 文件。</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>键盘快捷键(&amp;K)…</translation>
    </message>
    <message>
        <source>Pro&amp;ject tree</source>
        <translation>项目树(&amp;J)</translation>
    </message>
    <message>
        <source>Show setups, bodies, fixtures, tools, takes, paths and program as a tree.</source>
        <translation>以树形显示装夹、实体、夹具、刀具、录制、刀路和程序。</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Show the help on the current step.</source>
        <translation>显示当前步骤的帮助。</translation>
    </message>
    <message>
        <source>Click points on the part: diameter, wall thickness, area, distances and angle.</source>
        <translation>单击零件上的点：直径、壁厚、面积、距离和角度。</translation>
    </message>
    <message>
        <source>Change the shortcuts of actions.</source>
        <translation>更改操作的快捷键。</translation>
    </message>
    <message>
        <source>E&amp;xcess stock</source>
        <translation>残料(&amp;X)</translation>
    </message>
    <message>
        <source>Colour the workpiece by the stock that is left on the part, during milling, too. Rest the pointer on it to read how much.</source>
        <translation>按零件上剩余的材料为工件着色，铣削时也如此。将指针停在工件上可读取残料量。</translation>
    </message>
    <message>
        <source>&amp;Breakpoint</source>
        <translation>断点(&amp;B)</translation>
    </message>
    <message>
        <source>Stop a play of the program before the line of the cursor, or no longer. A click on the line&apos;s number does the same.</source>
        <translation>播放程序时在光标所在行之前停止，或取消停止。单击行号效果相同。</translation>
    </message>
    <message>
        <source>State how well a take was milled, and compare it with a reference, for training.</source>
        <translation>显示一段录制铣削得如何，并与参考录制比较，用于练习。</translation>
    </message>
    <message>
        <source>&amp;First job</source>
        <translation>第一个作业(&amp;F)</translation>
    </message>
    <message>
        <source>Start a guide through a complete job on the sample part, step by step.</source>
        <translation>在示例零件上，按步骤引导完成一个完整的作业。</translation>
    </message>
    <message>
        <source>F&amp;aces of the part…</source>
        <translation>零件的面(&amp;A)…</translation>
    </message>
    <message>
        <source>List the faces of the part with the gouges and the stock that the program leaves on each; a click shows the worst point.</source>
        <translation>列出零件的面，以及程序在各面上留下的过切和残料；单击即显示最差的点。</translation>
    </message>
    <message>
        <source>Mo&amp;ve the take up</source>
        <translation>上移录制(&amp;V)</translation>
    </message>
    <message>
        <source>Replay the take that is selected in the project tree or on the timeline before the take above it. The workpiece at the end and the paths stay as they are.</source>
        <translation>把项目树或时间轴上所选的录制放到其上一段录制之前重放。最终的工件和刀路保持不变。</translation>
    </message>
    <message>
        <source>Move the take do&amp;wn</source>
        <translation>下移录制(&amp;W)</translation>
    </message>
    <message>
        <source>Replay the take that is selected in the project tree or on the timeline after the take below it. The workpiece at the end and the paths stay as they are.</source>
        <translation>把项目树或时间轴上所选的录制放到其下一段录制之后重放。最终的工件和刀路保持不变。</translation>
    </message>
    <message>
        <source>Copy the selected take with its strokes and what is switched off. No path mills the copy until its menu adds it.</source>
        <translation>复制所选录制，连同其笔画和停用部分。在副本的菜单中加入刀路之前，没有刀路铣削该副本。</translation>
    </message>
    <message>
        <source>C&amp;ompare paths…</source>
        <translation>比较刀路(&amp;O)…</translation>
    </message>
    <message>
        <source>Compare the path with another one, with the recording or with itself without an edit: lengths, time and deviation.</source>
        <translation>将刀路与另一条刀路、与录制或与去掉某个编辑步骤后的自身比较：长度、时间和偏差。</translation>
    </message>
    <message>
        <source>Sco&amp;re a take…</source>
        <translation>评分录制(&amp;R)…</translation>
    </message>
    <message>
        <source>Dupl&amp;icate the take</source>
        <translation>复制录制(&amp;I)</translation>
    </message>
    <message>
        <source>A&amp;dd a fixture…</source>
        <translation>添加夹具(&amp;D)…</translation>
    </message>
    <message>
        <source>Compute roughing, finishing, a pocket, a profile, drilling, threads or engraving with the loaded tool.</source>
        <translation>用当前刀具计算粗加工、精加工、型腔、轮廓、钻孔、螺纹或雕刻。</translation>
    </message>
    <message>
        <source>Pick &amp;holes for a pass</source>
        <translation>为走刀选择孔(&amp;H)</translation>
    </message>
    <message>
        <source>Insert a &amp;point</source>
        <translation>插入点(&amp;P)</translation>
    </message>
    <message>
        <source>Insert a point where the path is selected. Drag it in the view to move it; the stroke follows it smoothly.</source>
        <translation>在刀路所选处插入一点。在视图中拖动可移动它；笔画平滑地跟随。</translation>
    </message>
    <message>
        <source>Place a vise, clamp, screw, parallels or plate of the library with the mouse; the tool keeps clear of it.</source>
        <translation>用鼠标放置夹具库中的虎钳、压板、螺钉、平行垫铁或底板；刀具会避开它。</translation>
    </message>
    <message>
        <source>&amp;Handles in the view</source>
        <translation>视图中的手柄(&amp;H)</translation>
    </message>
    <message>
        <source>Show arrows, squares and rings that move and rotate the part, or the fixture that is being placed, by the mouse. Shift: fine; Ctrl: in steps.</source>
        <translation>显示箭头、方块和圆环，用鼠标移动和旋转零件或正在放置的夹具。Shift：微调；Ctrl：按步进。</translation>
    </message>
    <message>
        <source>&amp;Stop the tool at the stock</source>
        <translation>刀具停在毛坯处(&amp;S)</translation>
    </message>
    <message>
        <source>The face of the part or stock that the tool touches becomes zero along its axis, as with an edge finder.</source>
        <translation>刀具接触的零件面或毛坯面成为其所在轴的零点，如同使用寻边器。</translation>
    </message>
    <message>
        <source>&amp;Keep from the stock</source>
        <translation>与毛坯保持距离(&amp;K)</translation>
    </message>
    <message>
        <source>Shank and holder push back before they touch the stock. The distance is set with the devices.</source>
        <translation>刀杆和刀柄在碰到毛坯之前就会推回。距离在设备对话框中设置。</translation>
    </message>
    <message>
        <source>Compute ou&amp;tdated passes again</source>
        <translation>重新计算过时的走刀(&amp;T)</translation>
    </message>
    <message>
        <source>Compute those passes of the path again whose strokes have changed; all others stay as they are.</source>
        <translation>重新计算刀路中笔画已改变的走刀；其他走刀保持不变。</translation>
    </message>
    <message>
        <source>Edit with the st&amp;ylus</source>
        <translation>用触笔编辑(&amp;Y)</translation>
    </message>
    <message>
        <source>Move points of the path with the chosen stylus, and feel part and fixtures.</source>
        <translation>用所选的触笔移动刀路上的点，并感受零件和夹具。</translation>
    </message>
    <message>
        <source>Measure the wor&amp;kpiece</source>
        <translation>测量工件(&amp;K)</translation>
    </message>
    <message>
        <source>Click points on the workpiece as it is milled: thickness, depth, width, diameter, stock left on the part, distances and angle.</source>
        <translation>单击已铣削工件上的点：厚度、深度、宽度、直径、零件上的残料、距离和角度。</translation>
    </message>
    <message>
        <source>Until a recording starts, the stock stops the tool, as it was before milling, so that its sides can be touched off.</source>
        <translation>在录制开始之前，铣削前的毛坯会挡住刀具，以便用刀具碰触其侧面。</translation>
    </message>
    <message>
        <source>Record a session trace…</source>
        <translation>记录会话轨迹…</translation>
    </message>
    <message>
        <source>Write every reading of the stylus, from entering mill mode until leaving it, to a file that &quot;burin mill&quot; replays to the bit.</source>
        <translation>将从进入到退出铣削模式的每个触笔读数写入文件，“burin mill”可逐位精确重放。</translation>
    </message>
    <message>
        <source>Click holes of the part for drilling or thread milling with the loaded tool, or studs for external threads.</source>
        <translation>单击零件上的孔，用当前刀具钻孔或铣螺纹，或单击凸台以铣外螺纹。</translation>
    </message>
</context>
<context>
    <name>Argument</name>
    <message>
        <source>NAME</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>FORCES</source>
        <translation>测力数据</translation>
    </message>
    <message>
        <source>MODEL</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>PROJECT</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>NEW</source>
        <translation>新项</translation>
    </message>
    <message>
        <source>PATH</source>
        <translation>刀路</translation>
    </message>
    <message>
        <source>TAKE</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>LINE</source>
        <translation>行</translation>
    </message>
    <message>
        <source>PROGRAM</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>OTHER</source>
        <translation>另一个</translation>
    </message>
    <message>
        <source>FLUTES</source>
        <translation>刃部</translation>
    </message>
</context>
<context>
    <name>BodyMenu</name>
    <message>
        <source>Draw this body again.</source>
        <translation>重新绘制此实体。</translation>
    </message>
    <message>
        <source>Draw these bodies again.</source>
        <translation>重新绘制这些实体。</translation>
    </message>
    <message>
        <source>Do not draw this body; nothing else changes.</source>
        <translation>不绘制此实体；其他不变。</translation>
    </message>
    <message>
        <source>Do not draw these bodies; nothing else changes.</source>
        <translation>不绘制这些实体；其他不变。</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>Show this one &amp;alone</source>
        <translation>仅显示此项(&amp;A)</translation>
    </message>
    <message>
        <source>Show these &amp;alone</source>
        <translation>仅显示这些(&amp;A)</translation>
    </message>
    <message>
        <source>Hide all other bodies.</source>
        <translation>隐藏其他所有实体。</translation>
    </message>
    <message>
        <source>Show a&amp;ll</source>
        <translation>全部显示(&amp;L)</translation>
    </message>
    <message>
        <source>Draw all bodies again.</source>
        <translation>重新绘制所有实体。</translation>
    </message>
    <message>
        <source>&amp;Role</source>
        <translation>角色(&amp;R)</translation>
    </message>
    <message>
        <source>Recordings depend on the roles of bodies.</source>
        <translation>录制依赖于实体的角色。</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>%1 的颜色</translation>
    </message>
    <message>
        <source>&amp;Colour…</source>
        <translation>颜色(&amp;C)…</translation>
    </message>
    <message>
        <source>Choose the colour in which the view shows it.</source>
        <translation>选择视图中显示所用的颜色。</translation>
    </message>
    <message>
        <source>&amp;Without a colour of its own</source>
        <translation>不用自己的颜色(&amp;W)</translation>
    </message>
    <message>
        <source>Show it in the colour of parts without a colour.</source>
        <translation>以没有颜色的零件的颜色显示。</translation>
    </message>
</context>
<context>
    <name>BodyRows</name>
    <message>
        <source>Tick: shown in the view.</source>
        <translation>勾选：在视图中显示。</translation>
    </message>
    <message>
        <source>several roles</source>
        <translation>多种角色</translation>
    </message>
    <message>
        <source>1 body. Tick: shown in the view.</source>
        <translation>1 个实体。勾选：在视图中显示。</translation>
    </message>
    <message numerus="yes">
        <source>%n bodies. Tick: shown in the view.</source>
        <translation>
            <numerusform>%n 个实体。勾选：在视图中显示。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Buttons</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this window.</source>
        <translation>关闭此窗口。</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>neither &quot;%1&quot; nor the project was changed</source>
        <translation>“%1”和项目均未更改</translation>
    </message>
    <message>
        <source>state a reason</source>
        <translation>说明理由</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1到%2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>一个数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a value.</source>
        <translation>“%1”需要一个值。</translation>
    </message>
    <message>
        <source>A command is missing; &quot;burin --help&quot; lists the commands.</source>
        <translation>缺少命令；“burin --help”可列出命令。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing; &quot;burin COMMAND --help&quot; shows what a command needs.</source>
        <translation>缺少“%1”；“burin 命令 --help”可显示命令所需的内容。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no argument of this command; &quot;burin COMMAND --help&quot; lists them.</source>
        <translation>“%1”不是此命令的参数；“burin 命令 --help”可列出参数。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; can&apos;t be used together.</source>
        <translation>“%1”和“%2”不能同时使用。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can only be used with &quot;%2&quot;.</source>
        <translation>“%1”只能与“%2”一起使用。</translation>
    </message>
    <message>
        <source>The arguments can&apos;t be understood (%1).</source>
        <translation>无法理解参数（%1）。</translation>
    </message>
    <message>
        <source>The tool can&apos;t reach anything to mill. Use a smaller or longer tool, or accept it with --override.</source>
        <translation>刀具够不到任何可铣削的部位。使用更小或更长的刀具，或用 --override 接受此情况。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was written already</source>
        <translation>“%1”已写出</translation>
    </message>
    <message>
        <source>the S-RLE engine and cutting, compared with the paper&apos;s method, dense grids, OpenVDB and VTK</source>
        <translation>S-RLE 引擎和切削，与论文方法、稠密网格、OpenVDB 和 VTK 比较</translation>
    </message>
    <message>
        <source>reading programs back and judging them, compared with CAMotics, and where the time goes</source>
        <translation>程序的回读和判定，与 CAMotics 比较，以及时间消耗在何处</translation>
    </message>
    <message>
        <source>CPU time and memory at three sizes of recordings, programs, paths, stocks and models, and how they grow</source>
        <translation>三种规模的录制、程序、刀路、毛坯和模型的 CPU 时间和内存，以及其增长情况</translation>
    </message>
    <message>
        <source>the haptic loop: cost of a tick, push-back, stability, guards</source>
        <translation>力反馈循环：周期耗时、反推力、稳定性、保护机制</translation>
    </message>
    <message>
        <source>(not built: tests/run --bench builds it)</source>
        <translation>（未构建：用 tests/run --bench 构建）</translation>
    </message>
    <message>
        <source>%1: %2 of %3 records, noise %4 N tangential, %5 N radial</source>
        <translation>%1：%3条记录中的%2条，切向噪声%4 N，径向噪声%5 N</translation>
    </message>
    <message>
        <source>%1 J/mm^3, chips of %2 mm</source>
        <translation>%1 J/mm^3，切屑厚度%2 mm</translation>
    </message>
    <message>
        <source>line %1 left out: %2</source>
        <translation>第%1行已略去：%2</translation>
    </message>
    <message>
        <source>not written (--dry-run)</source>
        <translation>未写出（--dry-run）</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>正在导入</translation>
    </message>
    <message>
        <source>Making the project</source>
        <translation>正在创建项目</translation>
    </message>
    <message>
        <source>Embedding</source>
        <translation>正在嵌入</translation>
    </message>
    <message>
        <source>Computing the tool&apos;s boundary</source>
        <translation>正在计算刀具的边界</translation>
    </message>
    <message>
        <source>Milling</source>
        <translation>正在铣削</translation>
    </message>
    <message>
        <source>Editing</source>
        <translation>正在编辑</translation>
    </message>
    <message>
        <source>Posting and checking</source>
        <translation>正在后处理并检查</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>正在写出</translation>
    </message>
    <message>
        <source>project  %1</source>
        <translation>项目     %1</translation>
    </message>
    <message>
        <source>program  %1, %2 blocks</source>
        <translation>程序     %1，%2个程序段</translation>
    </message>
    <message>
        <source>program  refused, %1 blocks</source>
        <translation>程序     已拒绝，%1个程序段</translation>
    </message>
    <message>
        <source>picture  %1</source>
        <translation>图片     %1</translation>
    </message>
    <message>
        <source>report   %1</source>
        <translation>报告     %1</translation>
    </message>
    <message>
        <source>mode %1: %2</source>
        <translation>模式%1：%2</translation>
    </message>
    <message>
        <source>BODY=NAME</source>
        <translation>实体=名称</translation>
    </message>
    <message>
        <source>no project was made</source>
        <translation>未创建项目</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>正在保存</translation>
    </message>
    <message>
        <source>part %1 mm^3 in stock %2 mm^3, %3 x %4 x %5 voxels of %6 mm</source>
        <translation>零件%1 mm^3，毛坯%2 mm^3，%3 x %4 x %5个%6 mm 的体素</translation>
    </message>
    <message>
        <source>verdict  out of date: inputs of the program&apos;s check have changed; post it again</source>
        <translation>结论     已过期：程序检查的输入已更改；重新进行后处理</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>强制放行</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>verdict  %2: gouge %3 mm (tolerance %4 mm), %1 error</source>
        <translation>结论     %2：过切%3 mm（公差%4 mm），%1个错误</translation>
    </message>
    <message>
        <source>verdict  %2: gouge %3 mm (tolerance %4 mm), %1 errors</source>
        <translation>结论     %2：过切%3 mm（公差%4 mm），%1个错误</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>take     %1 %2: %3 samples, %4, tool %5</source>
        <translation>录制     %1 %2：%3个采样点，%4，刀具%5</translation>
    </message>
    <message>
        <source>take     %1 %2: %3 samples, %4, tool %5, incomplete</source>
        <translation>录制     %1 %2：%3个采样点，%4，刀具%5，不完整</translation>
    </message>
    <message>
        <source>path     %1 %2: %3 takes, %4 edits</source>
        <translation>刀路     %1 %2：%3个录制，%4个编辑步骤</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>正在打开</translation>
    </message>
    <message>
        <source>(recovered from a run that was interrupted)</source>
        <translation>（从中断的运行中恢复）</translation>
    </message>
    <message>
        <source>stock    %1, voxel %2 mm</source>
        <translation>毛坯     %1，体素%2 mm</translation>
    </message>
    <message>
        <source>axis     %1</source>
        <translation>刀轴     %1</translation>
    </message>
    <message>
        <source>program  %1 (%2, %3)</source>
        <translation>程序     %1（%2，%3）</translation>
    </message>
    <message>
        <source>typical  %1</source>
        <translation>典型     %1</translation>
    </message>
    <message>
        <source>own      %1</source>
        <translation>自有     %1</translation>
    </message>
    <message>
        <source>%1: removed</source>
        <translation>%1：已删除</translation>
    </message>
    <message>
        <source>; shank or holder touched in %1 ticks</source>
        <translation>；刀杆或刀柄在%1个周期内发生接触</translation>
    </message>
    <message>
        <source>; %2 held the tool in %1 ticks</source>
        <translation>；%2在%1个周期内挡住了刀具</translation>
    </message>
    <message>
        <source>; the axis was held in %1 ticks</source>
        <translation>；刀轴在%1个周期内被保持</translation>
    </message>
    <message>
        <source>take %1: %2 samples, %3 s, removed %4 mm^3; tick %5 us (p50), %6 us (p99.9), %7 Hz</source>
        <translation>录制%1：%2个采样点，%3 s，去除%4 mm^3；周期%5 us (p50)、%6 us (p99.9)，%7 Hz</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not state how much of the cutting force was felt: %2 of it is assumed, as for the virtual operator. Set it with --felt; positions and the removed material don&apos;t depend on it, forces do.</source>
        <translation>“%1”未说明感受到的切削力占多大比例：与虚拟操作员相同，假定为%2。可用 --felt 设定；位置和去除的材料与此无关，力则与此有关。</translation>
    </message>
    <message>
        <source>%1, as when the trace was recorded</source>
        <translation>%1，与轨迹录制时相同</translation>
    </message>
    <message>
        <source>with --felt, a trace that does not state how much of the cutting force was felt</source>
        <translation>使用 --felt 时，应为未说明切削力感受比例的轨迹</translation>
    </message>
    <message>
        <source>--realtime with a device</source>
        <translation>使用设备时加 --realtime</translation>
    </message>
    <message>
        <source>operator, trace:FILE, device:NAME</source>
        <translation>operator、trace:文件、device:名称</translation>
    </message>
    <message>
        <source>no file with the operator; one if --stylus is a trace or a device</source>
        <translation>使用操作员时不给文件；--stylus 为轨迹或设备时给一个文件</translation>
    </message>
    <message>
        <source>the recording is kept, and the next command that opens the project recovers it</source>
        <translation>录制已保留，下一个打开该项目的命令会将其恢复</translation>
    </message>
    <message>
        <source>nothing was milled</source>
        <translation>未铣削任何内容</translation>
    </message>
    <message>
        <source>path %1 %2, takes%3</source>
        <translation>刀路%1 %2，录制%3</translation>
    </message>
    <message>
        <source>no paths</source>
        <translation>没有刀路</translation>
    </message>
    <message>
        <source>recordings made with %1, as the first one</source>
        <translation>用刀具%1做的录制，与第一个录制相同</translation>
    </message>
    <message>
        <source>0 to %1 (exclusive)</source>
        <translation>0 到%1（不含）</translation>
    </message>
    <message>
        <source>an edit of an earlier version; this one is current</source>
        <translation>早期版本的编辑步骤；此步骤已是当前版本</translation>
    </message>
    <message>
        <source>%1 points, error budget %2 mm, climb %3 mm, conventional %4 mm</source>
        <translation>%1个点，误差预算%2 mm，顺铣%3 mm，逆铣%4 mm</translation>
    </message>
    <message>
        <source>%1: %2 -&gt; %3 points, at most %4 mm</source>
        <translation>%1：%2 -&gt; %3个点，最大%4 mm</translation>
    </message>
    <message>
        <source>%1: %2 samples</source>
        <translation>%1：%2个采样点</translation>
    </message>
    <message>
        <source>Replaying the takes</source>
        <translation>正在重放录制</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>正在绘制</translation>
    </message>
    <message>
        <source>%1: %2 blocks</source>
        <translation>%1：%2个程序段</translation>
    </message>
    <message>
        <source>The project changed after its program was posted; the restart is judged by the project as it is now.</source>
        <translation>程序后处理之后项目有更改；重新开始的程序按项目的当前状态判定。</translation>
    </message>
    <message>
        <source>first cut: line %1 of the interrupted program, from %2 mm of path before it; the tool comes down at %3</source>
        <translation>首次切削：中断程序的第%1行，从该处之前%2 mm 的刀路开始；刀具在%3处下刀</translation>
    </message>
    <message>
        <source>Restarting and checking</source>
        <translation>正在重新开始并检查</translation>
    </message>
    <message>
        <source>Reading fixtures</source>
        <translation>正在读取夹具</translation>
    </message>
    <message>
        <source>machine  %1</source>
        <translation>机床     %1</translation>
    </message>
    <message>
        <source>machine  %1, dialect %2</source>
        <translation>机床     %1，方言%2</translation>
    </message>
    <message>
        <source>units    %1</source>
        <translation>单位     %1</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>正在检查</translation>
    </message>
    <message>
        <source>Burin ran out of memory. Choose a larger voxel.</source>
        <translation>Burin 内存不足。选择更大的体素。</translation>
    </message>
    <message>
        <source>Internal error in Burin; report this: %1</source>
        <translation>Burin 内部错误；请报告：%1</translation>
    </message>
    <message>
        <source>X=, Y= or Z= and a position in mm, such as X=12.5</source>
        <translation>X=、Y= 或 Z= 加上以 mm 为单位的位置，例如 X=12.5</translation>
    </message>
    <message>
        <source>a position between %1 and %2 mm</source>
        <translation>%1到%2 mm 之间的位置</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外%1个</translation>
    </message>
    <message>
        <source>body     %1: %2 mm^3, %3 mm^2, %4 faces, %5 triangles</source>
        <translation>实体     %1：%2 mm^3，%3 mm^2，%4个面，%5个三角形</translation>
    </message>
    <message>
        <source>, open</source>
        <translation>，不封闭</translation>
    </message>
    <message>
        <source>warning  %1</source>
        <translation>警告     %1</translation>
    </message>
    <message>
        <source>note     %1</source>
        <translation>提示     %1</translation>
    </message>
    <message>
        <source>format   %1, unit %2</source>
        <translation>格式     %1，单位%2</translation>
    </message>
    <message>
        <source>size     %1 x %2 x %3 mm</source>
        <translation>尺寸     %1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>volume   %1 mm^3</source>
        <translation>体积     %1 mm^3</translation>
    </message>
    <message>
        <source>Bodies too small for the voxels to be protected: %1. Choose smaller voxels, or continue nevertheless with --override.</source>
        <translation>实体太小，以当前体素无法保护：%1。选择更小的体素，或用 --override 强制继续。</translation>
    </message>
    <message>
        <source>warning: %1</source>
        <translation>警告：%1</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2，共%3</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第%1行</translation>
    </message>
    <message>
        <source>program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>%1: %2 at %3</source>
        <translation>%1：%2，位于%3</translation>
    </message>
    <message>
        <source>%2, and on %1 more line</source>
        <translation>%2，另有%1行</translation>
    </message>
    <message>
        <source>%2, and on %1 more lines</source>
        <translation>%2，另有%1行</translation>
    </message>
    <message>
        <source>line %1, column %2: rejected by the control: %3</source>
        <translation>第%1行，第%2列：被控制系统拒绝：%3</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>第%1行，第%2列：%3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not written: the program failed its check. To write it nevertheless, state a reason with --override; the program&apos;s header shows the reason.</source>
        <translation>未写出“%1”：程序未通过检查。若仍要写出，用 --override 说明理由；程序头会显示该理由。</translation>
    </message>
    <message>
        <source>left out by %2: %3 mm of %4 mm, %1 part</source>
        <translation>被%2略去：%4 mm 中的%3 mm，%1段</translation>
    </message>
    <message>
        <source>left out by %2: %3 mm of %4 mm, %1 parts</source>
        <translation>被%2略去：%4 mm 中的%3 mm，%1段</translation>
    </message>
    <message>
        <source>%1 mm from %2: %3</source>
        <translation>自%2起%1 mm：%3</translation>
    </message>
    <message>
        <source>%1: of %2 entries into material %3 by ramp, %4 by helix, %5 by plunge</source>
        <translation>%1：切入材料%2次，其中斜坡下刀%3次，螺旋下刀%4次，垂直下刀%5次</translation>
    </message>
    <message>
        <source>plunge of %1 mm to %2: no room for a ramp or helix</source>
        <translation>垂直下刀%1 mm 到%2：没有斜坡下刀或螺旋下刀的空间</translation>
    </message>
    <message>
        <source>passed: gouge %1 mm (tolerance %2 mm, %3 points, %4 of them on exact geometry)</source>
        <translation>通过：过切%1 mm（公差%2 mm，%3个点，其中%4个在精确几何上）</translation>
    </message>
    <message>
        <source>refused: gouge %1 mm (tolerance %2 mm, %3 points, %4 of them on exact geometry)</source>
        <translation>已拒绝：过切%1 mm（公差%2 mm，%3个点，其中%4个在精确几何上）</translation>
    </message>
    <message>
        <source>excess   %1 mm at most, %2 mm on average, where the tool can reach</source>
        <translation>残料     最大%1 mm，平均%2 mm（刀具可到达处）</translation>
    </message>
    <message>
        <source>excess   %1 mm or more, %2 mm on average, where the tool can reach</source>
        <translation>残料     %1 mm 或更多，平均%2 mm（刀具可到达处）</translation>
    </message>
    <message>
        <source>removed  %2 mm^3 in %3 s, with accelerations, corners, dwells and %1 tool change (%4 s at the programmed feeds alone)</source>
        <translation>去除     %2 mm^3，用时%3 s，含加减速、拐角、暂停和%1次换刀（仅按编程进给为%4 s）</translation>
    </message>
    <message>
        <source>removed  %2 mm^3 in %3 s, with accelerations, corners, dwells and %1 tool changes (%4 s at the programmed feeds alone)</source>
        <translation>去除     %2 mm^3，用时%3 s，含加减速、拐角、暂停和%1次换刀（仅按编程进给为%4 s）</translation>
    </message>
    <message>
        <source>%2; without %1 move whose start the program does not state (approach, return)</source>
        <translation>%2；不含%1个程序未说明起点的移动（接近、返回）</translation>
    </message>
    <message>
        <source>%2; without %1 moves whose start the program does not state (approach, return)</source>
        <translation>%2；不含%1个程序未说明起点的移动（接近、返回）</translation>
    </message>
    <message>
        <source>machine  %1: typical values, not those of your machine (burin machines copy)</source>
        <translation>机床     %1：典型值，不是你的机床的值（burin machines copy）</translation>
    </message>
    <message>
        <source>load     peak %1 N, %2 W, %3 N m on line %4 at %5 s</source>
        <translation>负载     峰值%1 N、%2 W、%3 N m，在第%4行，%5 s 时</translation>
    </message>
    <message>
        <source>exact stop after every block</source>
        <translation>每个程序段后准停</translation>
    </message>
    <message>
        <source>exact path, stops at corners</source>
        <translation>精确路径，拐角处停止</translation>
    </message>
    <message>
        <source>blended within %1 mm</source>
        <translation>在%1 mm 内平滑过渡</translation>
    </message>
    <message>
        <source>blended without limit</source>
        <translation>无限制平滑过渡</translation>
    </message>
    <message>
        <source>line %1: %2 %3 mm at %4</source>
        <translation>第%1行：%2 %3 mm，位于%4</translation>
    </message>
    <message>
        <source>%1; %2 lines within %3 mm of that point</source>
        <translation>%1；有%2行在该点%3 mm 范围内</translation>
    </message>
    <message>
        <source>feeds    reduced on %1 move to the limits of spindle and tool (feed by engagement)</source>
        <translation>进给     有%1个移动降到主轴和刀具的极限（按吃刀量调整进给）</translation>
    </message>
    <message>
        <source>feeds    reduced on %1 moves to the limits of spindle and tool (feed by engagement)</source>
        <translation>进给     有%1个移动降到主轴和刀具的极限（按吃刀量调整进给）</translation>
    </message>
    <message>
        <source>corners  from line %1 on, as the program states: %2</source>
        <translation>拐角     从第%1行起，按程序指定：%2</translation>
    </message>
    <message>
        <source>remedy   %1: %2</source>
        <translation>对策     %1：%2</translation>
    </message>
    <message>
        <source>and %1 more warnings</source>
        <translation>以及另外%1条警告</translation>
    </message>
    <message>
        <source>and %1 more points with warnings</source>
        <translation>以及另外%1个有警告的点</translation>
    </message>
    <message>
        <source>X0,Y0,Z0,X1,Y1,Z1 in mm, each of the last three above its counterpart</source>
        <translation>X0,Y0,Z0,X1,Y1,Z1（mm），后三个值各大于对应的前三个值</translation>
    </message>
    <message>
        <source>box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>圆柱体</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>夹具</translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation>禁入区</translation>
    </message>
    <message>
        <source>fixed, free, or X,Y,Z that are not all zero</source>
        <translation>fixed、free，或不全为零的 X,Y,Z</translation>
    </message>
    <message>
        <source>middle, off, or X,Y,Z in mm</source>
        <translation>middle、off，或以 mm 为单位的 X,Y,Z</translation>
    </message>
    <message>
        <source>The project&apos;s machine &quot;%1&quot; is not on this computer; &quot;%2&quot; is used in its place. Choose another with --machine, or with burin setup --machine.</source>
        <translation>此计算机上没有项目的机床“%1”；改用“%2”。用 --machine 或 burin setup --machine 另选一台。</translation>
    </message>
    <message>
        <source>free, with the stylus</source>
        <translation>自由，随触笔</translation>
    </message>
    <message>
        <source>fixed, +Z</source>
        <translation>固定，+Z</translation>
    </message>
    <message>
        <source>chosen, %1</source>
        <translation>选定，%1</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: %3 from (%4) to (%5) mm, clearance %6 mm</source>
        <translation>%1“%2”：%3，从 (%4) 到 (%5) mm，安全间隙%6 mm</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;: %3 from (%4) to (%5) mm, clearance %6 mm, off</source>
        <translation>%1“%2”：%3，从 (%4) 到 (%5) mm，安全间隙%6 mm，关闭</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>the machine&apos;s travel</source>
        <translation>机床行程</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot;</source>
        <translation>%1“%2”</translation>
    </message>
    <message>
        <source>There is no display to open the window on; log in to a desktop, set DISPLAY, or use a command: &quot;burin demo&quot; does the whole job without one, &quot;burin --help&quot; lists the others.</source>
        <translation>没有可显示窗口的屏幕；登录桌面，设置 DISPLAY，或使用命令：“burin demo”无需屏幕即可完成整个作业，“burin --help”可列出其他命令。</translation>
    </message>
    <message>
        <source>An earlier version of Burin saved this project; the previous file is kept as &quot;%1&quot;.</source>
        <translation>此项目由早期版本的 Burin 保存；原文件保留为“%1”。</translation>
    </message>
    <message>
        <source>a model file, or --free-carving</source>
        <translation>模型文件，或 --free-carving</translation>
    </message>
    <message>
        <source>shipped  K %1 J/mm^3  %2</source>
        <translation>自带     K %1 J/mm^3  %2</translation>
    </message>
    <message>
        <source>own      K %1 J/mm^3  %2</source>
        <translation>自有     K %1 J/mm^3  %2</translation>
    </message>
    <message>
        <source>%1 voxels of %2 mm</source>
        <translation>%1个%2 mm 的体素</translation>
    </message>
    <message>
        <source>  %1: %2 mm^3, %3 g, centre (%4, %5, %6) mm</source>
        <translation>  %1：%2 mm^3，%3 g，重心 (%4, %5, %6) mm</translation>
    </message>
    <message>
        <source>%1: %2 voxels of %3 mm</source>
        <translation>%1：%2个%3 mm 的体素</translation>
    </message>
    <message>
        <source>%1: %2 triangles</source>
        <translation>%1：%2个三角形</translation>
    </message>
    <message>
        <source>its table: %1</source>
        <translation>其表格：%1</translation>
    </message>
    <message>
        <source>%1 run ends within voxels were rounded to whole voxels; a volume file keeps them</source>
        <translation>%1个位于体素内部的游程端点已取整到整个体素；体数据文件会保留它们</translation>
    </message>
    <message>
        <source>intersecting: they share space</source>
        <translation>相交：有共同的空间</translation>
    </message>
    <message>
        <source>adjacent: they touch and share no space</source>
        <translation>相邻：相互接触，没有共同的空间</translation>
    </message>
    <message>
        <source>separate: there is a gap between them</source>
        <translation>分离：之间有间隙</translation>
    </message>
    <message>
        <source>part, stock, insert, protected-insert, fixture or ignored</source>
        <translation>part、stock、insert、protected-insert、fixture 或 ignored</translation>
    </message>
    <message>
        <source>x, y, z, or X,Y,Z</source>
        <translation>x、y、z，或 X,Y,Z</translation>
    </message>
    <message>
        <source>X,Y,Z,AX,AY,AZ,RADIUS,HEIGHT in mm: middle of an end face, direction of the axis, radius and height</source>
        <translation>X,Y,Z,AX,AY,AZ,半径,高度（mm）：一个端面的中心、轴线方向、半径和高度</translation>
    </message>
    <message>
        <source>NAME=MATERIAL,AXIS,FROM,TO: x, y or z, and two positions in mm, of which one may be left out</source>
        <translation>名称=材料,轴,起点,终点：x、y 或 z，以及两个以 mm 为单位的位置，其中一个可省略</translation>
    </message>
    <message>
        <source>LAYER:VALUE=FORMULA of X, Y and Z</source>
        <translation>材料层:值=公式（含 X、Y 和 Z）</translation>
    </message>
    <message>
        <source>LAYER:VALUE=AXIS:POSITION,VALUE;POSITION,VALUE…</source>
        <translation>材料层:值=轴:位置,值;位置,值…</translation>
    </message>
    <message>
        <source>mass not known</source>
        <translation>质量未知</translation>
    </message>
    <message>
        <source>  %1: %2 mm^3, %3, protected</source>
        <translation>  %1：%2 mm^3，%3，受保护</translation>
    </message>
    <message>
        <source>  %1: %2 mm^3, %3</source>
        <translation>  %1：%2 mm^3，%3</translation>
    </message>
    <message>
        <source>  %1: %2 from %3 to %4 %5 in %6 bands, each place within %7 %5</source>
        <translation>  %1：%2从%3到%4 %5，分%6级，各位置误差在%7 %5以内</translation>
    </message>
    <message>
        <source>free carving: there is no part, so nothing pushes the tool back</source>
        <translation>自由雕刻：没有零件，因此没有东西将刀具推回</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>form     %1</source>
        <translation>形状     %1</translation>
    </message>
    <message>
        <source>role     %1: %2</source>
        <translation>角色     %1：%2</translation>
    </message>
    <message>
        <source>layer    %1: %2, %3 from %4 to %5 mm</source>
        <translation>材料层   %1：%2，%3从%4到%5 mm</translation>
    </message>
    <message>
        <source>--stock-file FILE</source>
        <translation>--stock-file 文件</translation>
    </message>
    <message>
        <source>Reading the stock</source>
        <translation>正在读取毛坯</translation>
    </message>
    <message>
        <source>no part</source>
        <translation>没有零件</translation>
    </message>
    <message>
        <source>touched  line %1: with the tip at %2 shank and holder touch %3 voxels of %4 mm</source>
        <translation>接触     第%1行：刀尖在%2时，刀杆和刀柄接触%3个%4 mm 的体素</translation>
    </message>
    <message>
        <source>a known material, or --like MATERIAL</source>
        <translation>已知材料，或 --like 材料</translation>
    </message>
    <message>
        <source>shipped  T%1  %2 mm  %3</source>
        <translation>自带     T%1  %2 mm  %3</translation>
    </message>
    <message>
        <source>own      T%1  %2 mm  %3</source>
        <translation>自有     T%1  %2 mm  %3</translation>
    </message>
    <message>
        <source>profile of %1 lines, at most %2 mm wider than what the flutes sweep in a turn, never narrower</source>
        <translation>轮廓含%1条线，比刃部旋转一周扫过的范围最多宽%2 mm，绝不更窄</translation>
    </message>
    <message>
        <source>moved along Z by %1 mm, so that the tip is at 0</source>
        <translation>沿 Z 移动%1 mm，使刀尖位于 0</translation>
    </message>
    <message>
        <source>%1 gives no unit of length; it was read in mm.</source>
        <translation>%1未给出长度单位；已按 mm 读取。</translation>
    </message>
    <message>
        <source>coarser than --tolerance asks for: a finer profile has more lines than a tool can have</source>
        <translation>比 --tolerance 要求的粗：更细的轮廓线数会超过刀具允许的数量</translation>
    </message>
    <message>
        <source>setup %1</source>
        <translation>装夹%1</translation>
    </message>
    <message>
        <source>the number of a setup</source>
        <translation>装夹的编号</translation>
    </message>
    <message>
        <source>X,Y,Z=AXIS: a point on a face in mm, and x, -x, y, -y, z, -z or a direction that the face is to point along</source>
        <translation>X,Y,Z=轴：面上的一点（mm），以及 x、-x、y、-y、z、-z 或该面应朝向的方向</translation>
    </message>
    <message>
        <source>AXIS:DEGREES: x, y, z or X,Y,Z, and an angle</source>
        <translation>轴:度数：x、y、z 或 X,Y,Z，以及一个角度</translation>
    </message>
    <message>
        <source>X,Y,Z in mm</source>
        <translation>X,Y,Z（mm）</translation>
    </message>
    <message>
        <source>rotated by %1 degrees about %2</source>
        <translation>绕%2旋转%1度</translation>
    </message>
    <message>
        <source>moved by %1 mm</source>
        <translation>移动%1 mm</translation>
    </message>
    <message>
        <source>its stock is the workpiece after the checked program</source>
        <translation>其毛坯是已检查程序加工后的工件</translation>
    </message>
    <message>
        <source>its stock is the workpiece after the recordings, because there is no checked program that is up to date</source>
        <translation>其毛坯是录制后的工件，因为没有最新的已检查程序</translation>
    </message>
    <message>
        <source>the rotation is not a multiple of 90 degrees: faces of the stock may be off by up to %1 mm</source>
        <translation>旋转角不是 90 度的倍数：毛坯的面可能偏差达%1 mm</translation>
    </message>
    <message>
        <source>Preparing the stock</source>
        <translation>正在准备毛坯</translation>
    </message>
    <message>
        <source>setup    %1 %2</source>
        <translation>装夹     %1 %2</translation>
    </message>
    <message>
        <source>its stock is the workpiece of setup %1, which has changed since (update it with --update-stock)</source>
        <translation>其毛坯是装夹%1的工件，该工件此后已更改（用 --update-stock 更新）</translation>
    </message>
    <message>
        <source>its stock is the workpiece of setup %1</source>
        <translation>其毛坯是装夹%1的工件</translation>
    </message>
    <message>
        <source>0 to %1 mm, the travel of the machine &quot;%2&quot;</source>
        <translation>0 到%1 mm，即机床“%2”的行程</translation>
    </message>
    <message>
        <source>zero     %1</source>
        <translation>零点     %1</translation>
    </message>
    <message>
        <source>stock:X,Y,Z or part:X,Y,Z with low, middle or high for each axis, near:X,Y,Z or X,Y,Z in mm</source>
        <translation>stock:X,Y,Z 或 part:X,Y,Z（每个轴为 low、middle 或 high），near:X,Y,Z 或 X,Y,Z（mm）</translation>
    </message>
    <message>
        <source>low</source>
        <translation>最小侧</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中间</translation>
    </message>
    <message>
        <source>high</source>
        <translation>最大侧</translation>
    </message>
    <message>
        <source>G54 to G59, G59.1 to G59.3, or P1 to P300</source>
        <translation>G54 到 G59、G59.1 到 G59.3，或 P1 到 P300</translation>
    </message>
    <message>
        <source>%1, at X %2, Y %3, Z %4 mm</source>
        <translation>%1，位于 X %2、Y %3、Z %4 mm</translation>
    </message>
    <message>
        <source>%1, on the stock: X %2, Y %3, Z %4</source>
        <translation>%1，在毛坯上：X %2、Y %3、Z %4</translation>
    </message>
    <message>
        <source>%1, on the part: X %2, Y %3, Z %4</source>
        <translation>%1，在零件上：X %2、Y %3、Z %4</translation>
    </message>
    <message>
        <source>setup sheet  %1</source>
        <translation>装夹单  %1</translation>
    </message>
    <message>
        <source>an ID that is free, or --replace for one of your own</source>
        <translation>未被占用的 ID，或用 --replace 替换自己的一个</translation>
    </message>
    <message>
        <source>left out:</source>
        <translation>已略去：</translation>
    </message>
    <message>
        <source>path %1 %2</source>
        <translation>刀路%1 %2</translation>
    </message>
    <message>
        <source>a tool for the pass</source>
        <translation>用于该走刀的刀具</translation>
    </message>
    <message>
        <source>Computing the pass</source>
        <translation>正在计算走刀</translation>
    </message>
    <message>
        <source>%1 mm in %2 strokes</source>
        <translation>%1 mm，共%2个笔画</translation>
    </message>
    <message>
        <source>X,Y in mm</source>
        <translation>X,Y（mm）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not state its unit: one unit is taken as %2 mm. Set it with --unit.</source>
        <translation>“%1”未说明单位：一个单位按%2 mm 计。可用 --unit 设定。</translation>
    </message>
    <message>
        <source>another file, or --replace (recordings and passes in the project there: %1)</source>
        <translation>另一个文件，或 --replace（该处项目中的录制和走刀：%1）</translation>
    </message>
    <message>
        <source>%1 recordings and passes</source>
        <translation>%1个录制和走刀</translation>
    </message>
    <message>
        <source>a setup without recordings and passes, or --add-setup</source>
        <translation>没有录制和走刀的装夹，或 --add-setup</translation>
    </message>
    <message>
        <source>%1, the tool of this path; make a new path for another tool</source>
        <translation>%1，即此刀路的刀具；要用其他刀具，新建一条刀路</translation>
    </message>
    <message>
        <source>path %1 was deleted</source>
        <translation>刀路%1已删除</translation>
    </message>
    <message>
        <source>0.1 to 1000 mm</source>
        <translation>0.1 到 1000 mm</translation>
    </message>
    <message>
        <source>pass %1: %2 mm in %3 s, %4 % of it in air; %5 mm³ removed; engagement within %6° for 95 % of the cut, at most %7°</source>
        <translation>走刀%1：%2 mm，用时%3 s，其中 %4 % 为空切；去除%5 mm³；95 % 的切削接触角不超过%6°，最大%7°</translation>
    </message>
    <message>
        <source>%1 mm were skipped: too much stock is in the way of the tool. Rough it first, or use a longer tool.</source>
        <translation>跳过了%1 mm：刀具前方的残料太多。先进行粗加工，或使用更长的刀具。</translation>
    </message>
    <message>
        <source>%1 mm were skipped: fixtures or keep-out volumes are in the way.</source>
        <translation>跳过了%1 mm：被夹具或禁入区阻挡。</translation>
    </message>
    <message>
        <source>a path with a computed pass</source>
        <translation>含有计算走刀的刀路</translation>
    </message>
    <message>
        <source>Computing the preview</source>
        <translation>正在计算预览</translation>
    </message>
    <message>
        <source>holes    %1</source>
        <translation>孔       %1</translation>
    </message>
    <message>
        <source>; stock left on 99 % of the reachable part: at most %1 mm (most: %2 mm)</source>
        <translation>；零件可到达部分的 99 % 上残料最多%1 mm（最大值：%2 mm）</translation>
    </message>
    <message>
        <source>about %1 mm in %2 s at the feed of tool and material, without links</source>
        <translation>约%1 mm，用时%2 s，按刀具和材料的进给，不含连接</translation>
    </message>
    <message>
        <source>Testing the device</source>
        <translation>正在测试设备</translation>
    </message>
    <message>
        <source>no value, unless --stylus is a device or a trace that does not state how much of the cutting force was felt</source>
        <translation>不给值，除非 --stylus 是设备，或是未说明切削力感受比例的轨迹</translation>
    </message>
    <message>
        <source>; heaviest cut: %1 mm^2 of %2, engagement %3 degrees, depth %4 mm; feed for it: %5 mm/min at %6 rpm</source>
        <translation>；最重切削：%2 %1 mm^2，接触角%3度，深度%4 mm；对应进给：%5 mm/min，%6 rpm</translation>
    </message>
    <message>
        <source>Active guides of the project: %1</source>
        <translation>项目中已启用的导向：%1</translation>
    </message>
    <message>
        <source>changed bodies: %1</source>
        <translation>更改的实体：%1</translation>
    </message>
    <message>
        <source>new bodies: %1</source>
        <translation>新增的实体：%1</translation>
    </message>
    <message>
        <source>removed bodies: %1</source>
        <translation>移除的实体：%1</translation>
    </message>
    <message>
        <source>the part has not changed</source>
        <translation>零件没有更改</translation>
    </message>
    <message>
        <source>stock and program zero stay where they are, as there are recordings or passes; check the programs again</source>
        <translation>毛坯和程序零点保持原位，因为已有录制或走刀；重新检查程序</translation>
    </message>
    <message>
        <source>take %1 %2: %3 s switched off</source>
        <translation>录制%1 %2：已关闭%3 s</translation>
    </message>
    <message>
        <source>hash %1</source>
        <translation>哈希值%1</translation>
    </message>
    <message>
        <source>Rapids were left out: links replace them.</source>
        <translation>快速移动已略去：由连接代替。</translation>
    </message>
    <message>
        <source>%1 dwell was left out.</source>
        <translation>略去了%1个暂停。</translation>
    </message>
    <message>
        <source>%1 dwells were left out.</source>
        <translation>略去了%1个暂停。</translation>
    </message>
    <message>
        <source>%1 move was left out: the program does not state where it begins.</source>
        <translation>略去了%1个移动：程序未说明其起点。</translation>
    </message>
    <message>
        <source>%1 moves were left out: the program does not state where they begin.</source>
        <translation>略去了%1个移动：程序未说明其起点。</translation>
    </message>
    <message>
        <source>a tool for the program</source>
        <translation>程序所用的刀具</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>正在读取程序</translation>
    </message>
    <message>
        <source>X,Y,Z in mm, on the part</source>
        <translation>X,Y,Z，单位 mm，在零件上</translation>
    </message>
    <message>
        <source>%1 arc was converted to lines within 0.001 mm; fit-arcs restores it.</source>
        <translation>%1个圆弧已转换为直线，误差不超过 0.001 mm；fit-arcs 可将其恢复。</translation>
    </message>
    <message>
        <source>%1 arcs were converted to lines within 0.001 mm; fit-arcs restores them.</source>
        <translation>%1个圆弧已转换为直线，误差不超过 0.001 mm；fit-arcs 可将其恢复。</translation>
    </message>
    <message>
        <source>%1 mm of feed moves</source>
        <translation>进给移动 %1 mm</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>正在评分</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>better by %1</source>
        <translation>优于参考 %1</translation>
    </message>
    <message>
        <source>worse by %1</source>
        <translation>差于参考 %1</translation>
    </message>
    <message>
        <source>not comparable</source>
        <translation>无法比较</translation>
    </message>
    <message>
        <source>take %1 %2, compared with take %3 %4</source>
        <translation>录制 %1 %2，与录制 %3 %4 比较</translation>
    </message>
    <message>
        <source>take %1 %2</source>
        <translation>录制 %1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2, reference %3, ratio %4: %5</source>
        <translation>%1：%2，参考 %3，比值 %4：%5</translation>
    </message>
    <message>
        <source>Inspecting the faces</source>
        <translation>正在检查各面</translation>
    </message>
    <message>
        <source>face %1  gouge %2 mm  left %3 mm  in tolerance %4 %  area %5 mm^2  %6</source>
        <translation>面 %1  过切 %2 mm  残料 %3 mm  公差内 %4 %  面积 %5 mm^2  %6</translation>
    </message>
    <message>
        <source>an edit, a pass with --pass, or a take with --take</source>
        <translation>一个编辑步骤、用 --pass 指定的走刀，或用 --take 指定的录制</translation>
    </message>
    <message>
        <source>order of the takes: %1</source>
        <translation>录制的顺序：%1</translation>
    </message>
    <message>
        <source>a position from 1, or --before TAKE</source>
        <translation>从 1 开始的位置，或 --before 录制</translation>
    </message>
    <message>
        <source>take %1 is a copy of take %2</source>
        <translation>录制 %1 是录制 %2 的副本</translation>
    </message>
    <message>
        <source>without edit %1 (%2)</source>
        <translation>去掉编辑步骤 %1（%2）</translation>
    </message>
    <message>
        <source>a second path, --without or --recorded</source>
        <translation>第二条刀路、--without 或 --recorded</translation>
    </message>
    <message>
        <source>without edits</source>
        <translation>不含编辑步骤</translation>
    </message>
    <message>
        <source>%1 and %2 (%3)</source>
        <translation>%1和%2（%3）</translation>
    </message>
    <message>
        <source>at most %1 mm at (%2) mm, mean %3 mm; %4 % of its cuts (%5 mm) are farther</source>
        <translation>最大 %1 mm，位于 (%2) mm，平均 %3 mm；其切削移动的 %4 %（%5 mm）超出公差</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>切削移动</translation>
    </message>
    <message>
        <source>Plunges</source>
        <translation>垂直下刀</translation>
    </message>
    <message>
        <source>Rapids and retracts</source>
        <translation>快速移动和抬刀</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Time at feed</source>
        <translation>进给时间</translation>
    </message>
    <message>
        <source>Time at feed: unknown, as a path has moves without a feed</source>
        <translation>进给时间：未知，因为有刀路含没有进给的移动</translation>
    </message>
    <message>
        <source>No deviation: one of the paths has no cuts</source>
        <translation>没有偏差：其中一条刀路没有切削移动</translation>
    </message>
    <message>
        <source>First from second</source>
        <translation>第一条到第二条</translation>
    </message>
    <message>
        <source>Second from first</source>
        <translation>第二条到第一条</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>正在比较</translation>
    </message>
    <message>
        <source>%1 and %2, tolerance %3 mm</source>
        <translation>%1和%2，公差 %3 mm</translation>
    </message>
    <message>
        <source>the path has no edits</source>
        <translation>刀路没有编辑步骤</translation>
    </message>
    <message>
        <source>0 to %1</source>
        <translation>0 到 %1</translation>
    </message>
    <message>
        <source>assembly %2: %1 body, %3 mm^3</source>
        <translation>装配体 %2：%1个实体，%3 mm^3</translation>
    </message>
    <message>
        <source>assembly %2: %1 bodies, %3 mm^3</source>
        <translation>装配体 %2：%1个实体，%3 mm^3</translation>
    </message>
    <message>
        <source>body     %1: %2</source>
        <translation>实体     %1：%2</translation>
    </message>
    <message>
        <source>N=MOTION[,reversed][,gain=G][,dead=SHARE] with N from 1 to %1 and one of the motions %2</source>
        <translation>N=运动[,reversed][,gain=G][,dead=比例]，N 为 1 至 %1，运动为以下之一：%2</translation>
    </message>
    <message>
        <source>N=ACTION with N from 1 to %1 and one of the actions %2</source>
        <translation>N=动作，N 为 1 至 %1，动作为以下之一：%2</translation>
    </message>
    <message>
        <source>Leave the device at rest.</source>
        <translation>请勿触碰设备。</translation>
    </message>
    <message>
        <source>Move every axis to both of its ends.</source>
        <translation>将每个轴移动到两端。</translation>
    </message>
    <message>
        <source>%1: %2 mm (%3 to %4; %5)</source>
        <translation>%1：%2 mm（%3 至 %4；%5）</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>take %1 %2: there is no part to measure to</source>
        <translation>录制 %1 %2：没有可供测量的零件</translation>
    </message>
    <message>
        <source>take %1 %2: the tool is %3 to %4 mm from the part</source>
        <translation>录制 %1 %2：刀具距零件 %3 到 %4 mm</translation>
    </message>
    <message>
        <source>library &quot;%1&quot;:</source>
        <translation>刀具库“%1”：</translation>
    </message>
    <message>
        <source>%2: %1 tool</source>
        <translation>%2：%1 把刀具</translation>
    </message>
    <message>
        <source>%2: %1 tools</source>
        <translation>%2：%1 把刀具</translation>
    </message>
    <message>
        <source>library &quot;%1&quot; added</source>
        <translation>已新建刀具库“%1”</translation>
    </message>
    <message>
        <source>an empty library, or --with-tools to delete its tools</source>
        <translation>空的刀具库，或用 --with-tools 删除其中的刀具</translation>
    </message>
    <message>
        <source>library &quot;%2&quot; and %1 tool removed</source>
        <translation>已删除刀具库“%2”和 %1 把刀具</translation>
    </message>
    <message>
        <source>library &quot;%2&quot; and %1 tools removed</source>
        <translation>已删除刀具库“%2”和 %1 把刀具</translation>
    </message>
    <message>
        <source>mine, or a library of your own</source>
        <translation>mine，或您自己的刀具库</translation>
    </message>
    <message>
        <source>a tool of your own, or --copy</source>
        <translation>您自己的刀具，或使用 --copy</translation>
    </message>
    <message>
        <source>%1: in the library &quot;%2&quot;</source>
        <translation>%1：在刀具库“%2”中</translation>
    </message>
    <message>
        <source>%1 (%2): %3 1/min, %4 mm/min</source>
        <translation>%1（%2）：%3 1/min，%4 mm/min</translation>
    </message>
    <message>
        <source>any material</source>
        <translation>任意材料</translation>
    </message>
    <message>
        <source>no value, unless --fixed states that the tool does not turn</source>
        <translation>不给值，除非用 --fixed 说明刀具不旋转</translation>
    </message>
    <message>
        <source>does not turn: the models cut and touch the stock, with X at %1 degrees from X of the setup; the profile keeps them out of the part</source>
        <translation>不旋转：模型本身切削并接触毛坯，其 X 与装夹的 X 成 %1 度；轮廓把它们挡在零件之外</translation>
    </message>
    <message>
        <source>at=X,Y in mm</source>
        <translation>at=X,Y（mm）</translation>
    </message>
    <message>
        <source>place=X,Y,Z in mm</source>
        <translation>place=X,Y,Z（mm）</translation>
    </message>
    <message>
        <source>turn=DEGREES</source>
        <translation>turn=度数</translation>
    </message>
    <message>
        <source>a size and its length in mm: SIZE=MM</source>
        <translation>尺寸及其长度（mm）：尺寸=毫米</translation>
    </message>
    <message>
        <source>X,Y in mm, or the number of a hole of the part, 1 to %1</source>
        <translation>X,Y（mm），或零件孔的编号，1 至 %1</translation>
    </message>
    <message>
        <source>stated   unit %1: %2</source>
        <translation>注明     单位%1：%2</translation>
    </message>
    <message>
        <source>#RRGGBB, such as #3070c0</source>
        <translation>#RRGGBB，例如 #3070c0</translation>
    </message>
    <message>
        <source>mm, cm, dm, m, km, µm, inch, foot, yard, mil, stated, or mm per unit from 0.000001 to 1000000</source>
        <translation>mm、cm、dm、m、km、µm、inch、foot、yard、mil、stated，或每单位的毫米数（0.000001 至 1000000）</translation>
    </message>
    <message>
        <source>already deleted: %1</source>
        <translation>已删除：%1</translation>
    </message>
    <message>
        <source>already in the library: %1</source>
        <translation>已在库中：%1</translation>
    </message>
    <message>
        <source>Axes whose readings at rest were all 0 keep their rest and dead zone (%1). If the device reports an axis only once it was moved, move every axis once, then calibrate again.</source>
        <translation>静止时读数全为 0 的轴保留其静止位置和死区（%1）。如果设备在轴移动后才报告该轴，请先将每个轴移动一次，然后重新标定。</translation>
    </message>
    <message>
        <source>%1: %2 mm, or fitted to the stock (%3 to %4; %5)</source>
        <translation>%1：%2 mm，或与毛坯相适应（%3 至 %4；%5）</translation>
    </message>
    <message>
        <source>library &quot;%1&quot; renamed to &quot;%2&quot;</source>
        <translation>已将刀具库“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>; shank or holder were kept away from the stock in %1 ticks</source>
        <translation>；刀杆或刀柄在%1个周期内与毛坯保持距离</translation>
    </message>
    <message>
        <source>with --stock-distance, a trace that does not state this distance itself</source>
        <translation>使用 --stock-distance 时，应为未自行注明该距离的轨迹</translation>
    </message>
    <message>
        <source>no value, unless --stylus is a device</source>
        <translation>不给值，除非 --stylus 是设备</translation>
    </message>
    <message>
        <source>all passes are up to date</source>
        <translation>所有走刀均为最新</translation>
    </message>
    <message>
        <source>hollow, %1 mm in diameter and %2 mm deep (at most %3 mm narrower than the model): a core stands in it; the tool stays upright</source>
        <translation>空心，直径 %1 mm，深 %2 mm（最多比模型窄 %3 mm）：其中会留下芯柱；刀具保持竖直</translation>
    </message>
    <message>
        <source>the stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>X,Y,Z=AXIS: a point in mm, and x, -x, y, -y or -z</source>
        <translation>X,Y,Z=轴：一点（mm），以及 x、-x、y、-y 或 -z</translation>
    </message>
    <message>
        <source>a point from which the tool meets a side of the stock squarely, a ball with its middle below the upper edge</source>
        <translation>刀具从该点能正对毛坯侧面的位置；球头的球心须低于上边缘</translation>
    </message>
    <message>
        <source>%1 mm were skipped: already finished by hand strokes.</source>
        <translation>已跳过 %1 mm：手动笔画已精加工完毕。</translation>
    </message>
    <message>
        <source>pass %1 is out of date: hand strokes that it depends on have changed. Compute it again with &quot;recompute --outdated&quot;.</source>
        <translation>走刀 %1 已过时：它所依赖的手动笔画已更改。请用“recompute --outdated”重新计算。</translation>
    </message>
    <message>
        <source>a device with motors, and a test of 200 readings or more</source>
        <translation>带电机的设备，且测试至少有 200 个读数</translation>
    </message>
    <message>
        <source>used with --workpiece or --workpiece-file</source>
        <translation>与 --workpiece 或 --workpiece-file 一起使用</translation>
    </message>
    <message>
        <source>by=X,Y,Z in mm</source>
        <translation>by=X,Y,Z，单位 mm</translation>
    </message>
    <message>
        <source>X,Y in mm, or the number of a stud of the part, 1 to %1</source>
        <translation>X,Y（mm），或零件凸台的编号，1 至 %1</translation>
    </message>
    <message>
        <source>studs    %1</source>
        <translation>凸台     %1</translation>
    </message>
    <message>
        <source>touched  %1 %2 mm, within %3 mm</source>
        <translation>已碰触  %1 %2 mm，精确到 %3 mm</translation>
    </message>
    <message>
        <source>touched  %1 %2 mm</source>
        <translation>已碰触  %1 %2 mm</translation>
    </message>
</context>
<context>
    <name>Detail</name>
    <message>
        <source>an id that no shipped machine has; shipped machines can be copied, not changed</source>
        <translation>自带机床均未使用的 ID；自带机床只能复制，不能修改</translation>
    </message>
    <message>
        <source>an id that no machine has yet, or --replace</source>
        <translation>尚无机床使用的 ID，或 --replace</translation>
    </message>
    <message>
        <source>an id that no material has yet, or --replace</source>
        <translation>尚无材料使用的 ID，或 --replace</translation>
    </message>
    <message>
        <source>a machine of your own; those that Burin is shipped with can&apos;t be deleted</source>
        <translation>自建的机床；Burin 自带的机床不能删除</translation>
    </message>
    <message>
        <source>letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;, a letter or digit first</source>
        <translation>字母、数字、“-”、“_”和“.”，以字母或数字开头</translation>
    </message>
    <message>
        <source>a file other than &quot;%1&quot; and those that Burin keeps beside it</source>
        <translation>“%1”及 Burin 存放在其旁边的文件以外的文件</translation>
    </message>
    <message>
        <source>there is no home folder</source>
        <translation>没有用户主文件夹</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>is no plain file</source>
        <translation>不是普通文件</translation>
    </message>
    <message>
        <source>the system states no reason</source>
        <translation>系统未说明原因</translation>
    </message>
    <message>
        <source>%1; the new content stands there all the same</source>
        <translation>%1；新内容仍已写入该处</translation>
    </message>
    <message>
        <source>%1 is in the way</source>
        <translation>%1占住了该位置</translation>
    </message>
    <message>
        <source>its folder is protected</source>
        <translation>所在文件夹受保护</translation>
    </message>
    <message>
        <source>it was changed while it was read</source>
        <translation>读取过程中文件被更改</translation>
    </message>
    <message>
        <source>a take that no path uses (this one: %1)</source>
        <translation>未被任何刀路使用的录制（此录制：%1）</translation>
    </message>
    <message>
        <source>take %1, undone samples</source>
        <translation>录制%1，已撤销的采样点</translation>
    </message>
    <message>
        <source>take %1, sample %2</source>
        <translation>录制%1，采样点%2</translation>
    </message>
    <message>
        <source>path %1, edit %2</source>
        <translation>刀路%1，编辑步骤%2</translation>
    </message>
    <message>
        <source>take %1; the path is for %2</source>
        <translation>录制%1；该刀路用于%2</translation>
    </message>
    <message>
        <source>is not JSON</source>
        <translation>不是 JSON</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>不是 JSON 对象</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>出现两次</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>has to be the file&apos;s name</source>
        <translation>必须是文件名</translation>
    </message>
    <message>
        <source>differs from the file&apos;s name</source>
        <translation>与文件名不同</translation>
    </message>
    <message>
        <source>names no key of this file</source>
        <translation>不是此文件中的键</translation>
    </message>
    <message>
        <source>has to be above 0 with this rule</source>
        <translation>使用此规则时必须大于 0</translation>
    </message>
    <message>
        <source>has to be below largest_radius_mm</source>
        <translation>必须小于 largest_radius_mm</translation>
    </message>
    <message>
        <source>has to be above 0 and above the one before</source>
        <translation>必须大于 0 且大于前一个值</translation>
    </message>
    <message>
        <source>has to hold a point at least</source>
        <translation>必须至少包含一个点</translation>
    </message>
    <message>
        <source>has to be above 0</source>
        <translation>必须大于 0</translation>
    </message>
    <message>
        <source>has to be at most maximum_spindle_speed_rpm</source>
        <translation>不得大于 maximum_spindle_speed_rpm</translation>
    </message>
    <message>
        <source>has to be at most rapid_feed_mm_per_min, the greatest feed of all</source>
        <translation>不得大于 rapid_feed_mm_per_min，即最大的进给</translation>
    </message>
    <message>
        <source>has to be below the travel of Z</source>
        <translation>必须小于 Z 轴行程</translation>
    </message>
    <message>
        <source>has to be at most travel_mm[%1] from the machine&apos;s zero</source>
        <translation>离机床零点的距离不得大于 travel_mm[%1]</translation>
    </message>
    <message>
        <source>has {%1}, which is none of {%2}</source>
        <translation>含有 {%1}，它不属于 {%2}</translation>
    </message>
    <message>
        <source>has to hold one of {%1}</source>
        <translation>必须包含 {%1} 之一</translation>
    </message>
    <message>
        <source>has to be one line</source>
        <translation>必须是一行</translation>
    </message>
    <message>
        <source>has more than %1, which has to stand alone</source>
        <translation>除%1外还有其他内容，而它必须单独出现</translation>
    </message>
    <message>
        <source>has to be one of: %1</source>
        <translation>必须是以下之一：%1</translation>
    </message>
    <message>
        <source>has to be a whole number from %1 to %2</source>
        <translation>必须是%1到%2的整数</translation>
    </message>
    <message>
        <source>has to be whole numbers</source>
        <translation>必须是整数</translation>
    </message>
    <message>
        <source>has to be true or false</source>
        <translation>必须是 true 或 false</translation>
    </message>
    <message>
        <source>has to be a text that is not empty</source>
        <translation>必须是非空文本</translation>
    </message>
    <message>
        <source>has to be a list of texts</source>
        <translation>必须是文本列表</translation>
    </message>
    <message>
        <source>has to be a list of %1 numbers</source>
        <translation>必须是含%1个数的列表</translation>
    </message>
    <message>
        <source>has to be a list</source>
        <translation>必须是列表</translation>
    </message>
    <message>
        <source>has to be an object</source>
        <translation>必须是对象</translation>
    </message>
    <message>
        <source>has to be a number</source>
        <translation>必须是数字</translation>
    </message>
    <message>
        <source>has to be a number of at least %1</source>
        <translation>必须是不小于%1的数</translation>
    </message>
    <message>
        <source>has to be a number of at most %1</source>
        <translation>必须是不大于%1的数</translation>
    </message>
    <message>
        <source>has to be a number from %1 to %2</source>
        <translation>必须是%1到%2的数</translation>
    </message>
    <message>
        <source>has to be %1</source>
        <translation>必须是%1</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>一个数</translation>
    </message>
    <message>
        <source>a number of at least %1</source>
        <translation>不小于%1的数</translation>
    </message>
    <message>
        <source>a number of at most %1</source>
        <translation>不大于%1的数</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>%1到%2的数</translation>
    </message>
    <message>
        <source>the material needs a value above 0</source>
        <translation>材料需要大于 0 的值</translation>
    </message>
    <message>
        <source>left out: this type has none</source>
        <translation>略去：此类型没有该项</translation>
    </message>
    <message>
        <source>half the diameter for a ball end or lollipop</source>
        <translation>球头铣刀或球形T刀为直径的一半</translation>
    </message>
    <message>
        <source>above 0 and below half the diameter</source>
        <translation>大于 0 且小于直径的一半</translation>
    </message>
    <message>
        <source>0 for a sharp end</source>
        <translation>尖角为 0</translation>
    </message>
    <message>
        <source>above 0, at most 89</source>
        <translation>大于 0，不大于 89</translation>
    </message>
    <message>
        <source>at least 0 and below the diameter</source>
        <translation>不小于 0 且小于直径</translation>
    </message>
    <message>
        <source>small enough to round the edge of the tip</source>
        <translation>足够小，以便将刀尖边缘倒圆</translation>
    </message>
    <message>
        <source>small enough to leave a cone</source>
        <translation>足够小，以便留下圆锥部分</translation>
    </message>
    <message>
        <source>at most what the cone reaches at the end of the flutes (%1)</source>
        <translation>不大于圆锥在刃部末端达到的值（%1）</translation>
    </message>
    <message>
        <source>above half the diameter and below the diameter: where the ball ends and the shank begins</source>
        <translation>大于直径的一半且小于直径：球头结束、刀杆开始处</translation>
    </message>
    <message>
        <source>at least half the distance of the arc&apos;s ends</source>
        <translation>不小于圆弧两端距离的一半</translation>
    </message>
    <message>
        <source>an arc that rises all the way from its beginning to its end and stays off the axis</source>
        <translation>从起点到终点一直上升且不触及轴线的圆弧</translation>
    </message>
    <message>
        <source>at least one line or arc</source>
        <translation>至少一条直线或一个圆弧</translation>
    </message>
    <message>
        <source>at least the height at which the element begins: profiles never fall, so a cupped tip can&apos;t be drawn</source>
        <translation>不低于该元素起点的高度：轮廓从不下降，因此无法绘制内凹的刀尖</translation>
    </message>
    <message>
        <source>a point other than the element&apos;s beginning</source>
        <translation>不同于该元素起点的点</translation>
    </message>
    <message>
        <source>the height at which the profile ends</source>
        <translation>轮廓终点的高度</translation>
    </message>
    <message>
        <source>twice the profile&apos;s largest radius</source>
        <translation>轮廓最大半径的两倍</translation>
    </message>
    <message>
        <source>&gt; 0 and at least the corner radius</source>
        <translation>&gt; 0 且不小于圆角半径</translation>
    </message>
    <message>
        <source>at least the length of the flutes</source>
        <translation>不小于刃长</translation>
    </message>
    <message>
        <source>&gt; 0 and at most the length of the flutes</source>
        <translation>&gt; 0 且不大于刃长</translation>
    </message>
    <message>
        <source>not empty</source>
        <translation>非空</translation>
    </message>
    <message>
        <source>at least 0</source>
        <translation>不小于 0</translation>
    </message>
    <message>
        <source>at least 1</source>
        <translation>不小于 1</translation>
    </message>
    <message>
        <source>above 0</source>
        <translation>大于 0</translation>
    </message>
    <message>
        <source>two finite corners, each coordinate of the second above the first&apos;s</source>
        <translation>两个有限的角点，第二个的每个坐标都大于第一个</translation>
    </message>
    <message>
        <source>a finite length above 0 mm</source>
        <translation>大于 0 mm 的有限长度</translation>
    </message>
    <message>
        <source>a finite length of 0 mm or more</source>
        <translation>不小于 0 mm 的有限长度</translation>
    </message>
    <message>
        <source>finite lengths of 0 mm or more</source>
        <translation>不小于 0 mm 的有限长度</translation>
    </message>
    <message>
        <source>finite lengths</source>
        <translation>有限长度</translation>
    </message>
    <message>
        <source>a finite box</source>
        <translation>有限的长方体</translation>
    </message>
    <message>
        <source>a model with at least one body</source>
        <translation>至少含一个实体的模型</translation>
    </message>
    <message>
        <source>%1 voxels on one axis</source>
        <translation>一个轴上%1个体素</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1个体素</translation>
    </message>
    <message>
        <source>its triangles face inwards</source>
        <translation>其三角形朝内</translation>
    </message>
    <message>
        <source>no body</source>
        <translation>没有实体</translation>
    </message>
    <message>
        <source>%1 open edges</source>
        <translation>%1条开放边</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>缺少文件结尾</translation>
    </message>
    <message>
        <source>it refers to itself</source>
        <translation>它引用了自身</translation>
    </message>
    <message>
        <source>parts in other folders</source>
        <translation>其他文件夹中的零件</translation>
    </message>
    <message>
        <source>a tessellation alone</source>
        <translation>只有三角网格</translation>
    </message>
    <message>
        <source>no shape</source>
        <translation>没有形状</translation>
    </message>
    <message>
        <source>no faces</source>
        <translation>没有面</translation>
    </message>
    <message>
        <source>no triangles</source>
        <translation>没有三角形</translation>
    </message>
    <message>
        <source>triangle %1 of %2</source>
        <translation>第%1个三角形，共%2个</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>三角形%1</translation>
    </message>
    <message>
        <source>%1 of %2 faces of &quot;%3&quot;</source>
        <translation>%1个面，共%2个，属于“%3”</translation>
    </message>
    <message>
        <source>%1 triangles with %2 open edges</source>
        <translation>%1个三角形，有%2条开放边</translation>
    </message>
    <message>
        <source>1 face with %1</source>
        <translation>1 个面有%1</translation>
    </message>
    <message>
        <source>%1 faces with %2</source>
        <translation>%1个面有%2</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 条开放边</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 条边</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1条边</translation>
    </message>
    <message>
        <source>it answered something else</source>
        <translation>它返回了别的内容</translation>
    </message>
    <message>
        <source>its answer is damaged</source>
        <translation>其返回内容已损坏</translation>
    </message>
    <message>
        <source>its answer has no end</source>
        <translation>其返回内容没有结尾</translation>
    </message>
    <message>
        <source>signal %1 (%2)</source>
        <translation>信号%1（%2）</translation>
    </message>
    <message>
        <source>exit status %1 without an answer</source>
        <translation>退出状态%1，无返回内容</translation>
    </message>
    <message>
        <source>its end was lost</source>
        <translation>结尾已丢失</translation>
    </message>
    <message>
        <source>noise hides the cutting force; measure deeper cuts or more of them</source>
        <translation>噪声掩盖了切削力；测量更深或更多的切削</translation>
    </message>
    <message>
        <source>the forces on the workpiece point against the feed; are they those on the tool?</source>
        <translation>工件上的力与进给方向相反；是否为刀具上的力？</translation>
    </message>
    <message>
        <source>the forces on the tool point along the feed; are they those on the workpiece (--on-workpiece)?</source>
        <translation>刀具上的力沿进给方向；是否为工件上的力（--on-workpiece）？</translation>
    </message>
    <message>
        <source>the records disagree too much; look for air cuts, chatter or wrong conditions in them</source>
        <translation>测量记录相差太大；检查其中有无空切、颤振或错误的条件</translation>
    </message>
    <message>
        <source>the force of the edge comes out negative; use another law (--law kienzle or constant)</source>
        <translation>刃口力为负；改用其他定律（--law kienzle 或 constant）</translation>
    </message>
    <message>
        <source>the radial force pulls the tool into the material; use another projection (--projection)</source>
        <translation>径向力将刀具拉入材料；改用其他投影（--projection）</translation>
    </message>
    <message>
        <source>only %1 records can be used; measure %2 or more</source>
        <translation>只有%1条测量记录可用；至少测量%2条</translation>
    </message>
    <message>
        <source>the edge&apos;s force needs chips of different thickness; measure feeds that differ by a factor of %1 or more, or use another law (--law constant)</source>
        <translation>求刃口力需要不同厚度的切屑；测量相差至少%1倍的进给，或改用其他定律（--law constant）</translation>
    </message>
    <message>
        <source>an exponent needs chips of different thickness; measure feeds that differ by a factor of %1 or more</source>
        <translation>求指数需要不同厚度的切屑；测量相差至少%1倍的进给</translation>
    </message>
    <message>
        <source>noise hides the exponent; measure feeds that differ more, or more of them, or use a constant K</source>
        <translation>噪声掩盖了指数；测量相差更大或更多的进给，或使用恒定的 K</translation>
    </message>
    <message>
        <source>far off: %1 N tangential, %2 N radial deviation from the fit; %3 N and %4 N would count</source>
        <translation>偏离过大：与拟合值的切向偏差 %1 N，径向偏差 %2 N；不超过 %3 N 和 %4 N 才计入</translation>
    </message>
    <message>
        <source>far off: %1 N deviation from the fit; %2 N would count</source>
        <translation>偏离过大：与拟合值的偏差 %1 N；不超过 %2 N 才计入</translation>
    </message>
    <message>
        <source>nothing was removed</source>
        <translation>未去除任何材料</translation>
    </message>
    <message>
        <source>the feed is along the tool axis</source>
        <translation>进给沿刀具轴线方向</translation>
    </message>
    <message>
        <source>the column immersion does not say up or down</source>
        <translation>immersion 列未写明 up 或 down</translation>
    </message>
    <message>
        <source>is missing; write a number</source>
        <translation>缺失；填写一个数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number with a decimal point</source>
        <translation>“%1”不是带小数点的数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range; %2 to %3</source>
        <translation>“%1”超出范围；%2到%3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be above 0</source>
        <translation>“%1”必须大于 0</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no id; letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;, a letter or digit first</source>
        <translation>“%1”不是 ID；应为字母、数字、“-”、“_”和“.”，以字母或数字开头</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be a whole number from 1 to 1000</source>
        <translation>“%1”必须是 1 到 1000 的整数</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be slot, up, down or empty</source>
        <translation>“%1”必须是 slot、up、down 或留空</translation>
    </message>
    <message>
        <source>there is no row below the heading</source>
        <translation>表头下没有数据行</translation>
    </message>
    <message>
        <source>is not UTF-8; save the table as CSV UTF-8</source>
        <translation>不是 UTF-8；将表格另存为 CSV UTF-8</translation>
    </message>
    <message>
        <source>a quotation mark does not end</source>
        <translation>引号未闭合</translation>
    </message>
    <message>
        <source>has semicolons; save the table with commas and decimal points</source>
        <translation>含有分号；用逗号分隔并以小数点保存表格</translation>
    </message>
    <message>
        <source>is not known; call columns that are for people note…</source>
        <translation>未知；供人阅读的列应命名为 note…</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>出现两次</translation>
    </message>
    <message>
        <source>is missing; the first line has to name it</source>
        <translation>缺失；第一行必须列出它</translation>
    </message>
    <message>
        <source>the row has %1 values, the heading %2; write decimal points, not commas</source>
        <translation>该行有%1个值，表头有%2个；小数用小数点，不用逗号</translation>
    </message>
    <message>
        <source>the tool axis has no length</source>
        <translation>刀具轴线长度为零</translation>
    </message>
    <message>
        <source>the feed has no direction</source>
        <translation>进给没有方向</translation>
    </message>
    <message>
        <source>is more than the diameter</source>
        <translation>大于直径</translation>
    </message>
    <message>
        <source>a slot&apos;s radial depth is the diameter; write up or down</source>
        <translation>铣槽的径向切深即为直径；填写 up 或 down</translation>
    </message>
    <message>
        <source>its conditions differ from line %1 of the same cut; give it a name of its own</source>
        <translation>其条件与同一切削的第%1行不同；另取一个名称</translation>
    </message>
    <message>
        <source>value %1 is not a number</source>
        <translation>第%1个值不是数字</translation>
    </message>
    <message>
        <source>buttons is not a whole number from 0 to 4294967295</source>
        <translation>buttons 不是 0 到 4294967295 的整数</translation>
    </message>
    <message>
        <source>not %1 values between commas</source>
        <translation>不是以逗号分隔的%1个值</translation>
    </message>
    <message>
        <source>value 11 is neither 0 nor 1</source>
        <translation>第 11 个值既不是 0 也不是 1</translation>
    </message>
    <message>
        <source>value 12 is not a number of at least 0</source>
        <translation>第 12 个值不是不小于 0 的数</translation>
    </message>
    <message>
        <source>the quaternion&apos;s length is not 1</source>
        <translation>四元数的模不为 1</translation>
    </message>
    <message>
        <source>the first line must be %1</source>
        <translation>第一行必须是%1</translation>
    </message>
    <message>
        <source>the second line must be %1</source>
        <translation>第二行必须是%1</translation>
    </message>
    <message>
        <source>the time is not later than in the line before</source>
        <translation>时间不晚于前一行</translation>
    </message>
    <message>
        <source>no reading follows</source>
        <translation>其后没有读数</translation>
    </message>
    <message>
        <source>a session begins once, before its first reading</source>
        <translation>会话只开始一次，且在其第一个读数之前</translation>
    </message>
    <message>
        <source>the workpiece was changed there by something else than milling</source>
        <translation>该处的工件曾被铣削以外的操作更改</translation>
    </message>
    <message>
        <source>the boundary that this project&apos;s tool has is made of fewer</source>
        <translation>本项目刀具的边界由更少的部分组成</translation>
    </message>
    <message>
        <source>tile %1</source>
        <translation>分块%1</translation>
    </message>
    <message>
        <source>at least one reading</source>
        <translation>至少一个读数</translation>
    </message>
    <message>
        <source>times that rise</source>
        <translation>递增的时间</translation>
    </message>
    <message>
        <source>realtime with a device that keeps its own time</source>
        <translation>实时，因设备自带时钟</translation>
    </message>
    <message>
        <source>%1; its start is set by line %2 and line %3</source>
        <translation>%1；其起点由第%2行和第%3行设定</translation>
    </message>
    <message>
        <source>%1; its start is set by line %2</source>
        <translation>%1；其起点由第%2行设定</translation>
    </message>
    <message>
        <source>%1; distances are incremental since line %2</source>
        <translation>%1；自第%2行起距离为增量</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>第%1行，第%2列</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第%1行</translation>
    </message>
    <message>
        <source>a move of %1 mm, and up to %2 mm are checked</source>
        <translation>移动长 %1 mm，最多检查 %2 mm</translation>
    </message>
    <message>
        <source>all moves up to here are longer than the %1 mm that are checked</source>
        <translation>到此为止的所有移动都长于可检查的 %1 mm</translation>
    </message>
    <message>
        <source>a number of its own for each tool of a program</source>
        <translation>程序中每把刀具各有自己的编号</translation>
    </message>
    <message>
        <source>has to begin with a rapid move; link it first</source>
        <translation>必须以快速移动开始；先连接</translation>
    </message>
    <message>
        <source>has to begin with a rapid move</source>
        <translation>必须以快速移动开始</translation>
    </message>
    <message>
        <source>its tool has no number</source>
        <translation>其刀具没有编号</translation>
    </message>
    <message>
        <source>missing at point %1</source>
        <translation>点%1处缺失</translation>
    </message>
    <message>
        <source>point %1 is not finite</source>
        <translation>点%1不是有限值</translation>
    </message>
    <message>
        <source>point %1 can&apos;t be the end of an arc</source>
        <translation>点%1不能作为圆弧终点</translation>
    </message>
    <message>
        <source>%1 characters, limit %2</source>
        <translation>%1个字符，上限%2</translation>
    </message>
    <message>
        <source>%1, limit %2</source>
        <translation>%1，上限%2</translation>
    </message>
    <message>
        <source>not a time</source>
        <translation>不是时间</translation>
    </message>
    <message>
        <source>coordinate is not a valid position</source>
        <translation>坐标不是有效位置</translation>
    </message>
    <message>
        <source>centre is not a valid position</source>
        <translation>圆心不是有效位置</translation>
    </message>
    <message>
        <source>one program a tool</source>
        <translation>每把刀具一个程序</translation>
    </message>
    <message>
        <source>G54 to G59</source>
        <translation>G54 到 G59</translation>
    </message>
    <message>
        <source>a line with no cut from an unknown position behind it (line %1)</source>
        <translation>其后没有从未知位置开始的切削的行（第%1行）</translation>
    </message>
    <message>
        <source>a line with no cut without a feed behind it (line %1)</source>
        <translation>其后没有无进给切削的行（第%1行）</translation>
    </message>
    <message>
        <source>a line with no cut without a spindle behind it (line %1)</source>
        <translation>其后没有主轴未启动切削的行（第%1行）</translation>
    </message>
    <message>
        <source>none; the program cuts nothing</source>
        <translation>无；程序不切削任何材料</translation>
    </message>
    <message>
        <source>1 to %1, the line of the last cut</source>
        <translation>1 到%1，即最后一次切削所在的行</translation>
    </message>
    <message>
        <source>%1 to %2, a whole number</source>
        <translation>%1到%2的整数</translation>
    </message>
    <message>
        <source>coordinates from %1 to %2</source>
        <translation>%1到%2的坐标</translation>
    </message>
    <message>
        <source>%1 to %2 points</source>
        <translation>%1到%2个点</translation>
    </message>
    <message>
        <source>coordinates up to %1</source>
        <translation>不超过%1的坐标</translation>
    </message>
    <message>
        <source>a take and a tick of it, from 0</source>
        <translation>一个录制及其一个周期，从 0 起</translation>
    </message>
    <message>
        <source>a take and two ticks of it, the earlier one first</source>
        <translation>一个录制及其两个周期，较早的在前</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>三个数</translation>
    </message>
    <message>
        <source>a list of points, three numbers each</source>
        <translation>点的列表，每点三个数</translation>
    </message>
    <message>
        <source>no parameter of %1</source>
        <translation>不是%1的参数</translation>
    </message>
    <message>
        <source>a JSON object</source>
        <translation>JSON 对象</translation>
    </message>
    <message>
        <source>below half of the recording&apos;s rate</source>
        <translation>低于录制频率的一半</translation>
    </message>
    <message>
        <source>no more than %1 of so long a path</source>
        <translation>这么长的刀路最多%1份</translation>
    </message>
    <message>
        <source>moments that the path still has</source>
        <translation>刀路中仍存在的时刻</translation>
    </message>
    <message>
        <source>takes milled with the axis fixed at +Z (--axis fixed), unlike take %1</source>
        <translation>刀轴固定为 +Z（--axis fixed）铣削的录制，与录制%1不同</translation>
    </message>
    <message>
        <source>set-feed, then level-feed</source>
        <translation>先 set-feed，后 level-feed</translation>
    </message>
    <message>
        <source>one that has not ended</source>
        <translation>尚未结束的一个</translation>
    </message>
    <message>
        <source>none: the part alone is there</source>
        <translation>无：只有零件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to be a text</source>
        <translation>“%1”必须是文本</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>未知的键“%1”</translation>
    </message>
    <message>
        <source>not a JSON object</source>
        <translation>不是 JSON 对象</translation>
    </message>
    <message>
        <source>not JSON</source>
        <translation>不是 JSON</translation>
    </message>
    <message>
        <source>&quot;interface_version&quot; has to be a whole number</source>
        <translation>“interface_version”必须是整数</translation>
    </message>
    <message>
        <source>&quot;kind&quot; has to be &quot;%1&quot;</source>
        <translation>“kind”必须是“%1”</translation>
    </message>
    <message>
        <source>id &quot;%1&quot; is taken already</source>
        <translation>ID“%1”已被占用</translation>
    </message>
    <message>
        <source>unknown reason</source>
        <translation>原因未知</translation>
    </message>
    <message>
        <source>its entry point threw</source>
        <translation>其入口点抛出异常</translation>
    </message>
    <message>
        <source>its entry point gave nothing</source>
        <translation>其入口点未返回任何内容</translation>
    </message>
    <message>
        <source>it made nothing</source>
        <translation>它未生成任何内容</translation>
    </message>
    <message>
        <source>it threw: %1</source>
        <translation>它抛出异常：%1</translation>
    </message>
    <message>
        <source>it threw</source>
        <translation>它抛出异常</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1到%2</translation>
    </message>
    <message>
        <source>takes of the path&apos;s own setup</source>
        <translation>刀路自身装夹中的录制</translation>
    </message>
    <message>
        <source>a tool that cuts sideways and is nowhere wider below than above</source>
        <translation>能侧向切削且下部任何位置都不比上部宽的刀具</translation>
    </message>
    <message>
        <source>%1 must be file names without a folder</source>
        <translation>%1必须是不带文件夹的文件名</translation>
    </message>
    <message>
        <source>at least one body whose role is part, or free carving</source>
        <translation>至少一个角色为零件的实体，或自由雕刻</translation>
    </message>
    <message>
        <source>a box whose second corner lies above the first along each axis</source>
        <translation>第二角点在每个轴上都大于第一角点的长方体</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>a finite base, a radius and a height above 0 mm</source>
        <translation>有限的底点，以及大于 0 mm 的半径和高度</translation>
    </message>
    <message>
        <source>solids where a body has the role stock, a box or a cylinder</source>
        <translation>有实体角色为毛坯时可用 solids，或长方体、圆柱</translation>
    </message>
    <message>
        <source>a file where one was read, a box, a cylinder or solids</source>
        <translation>已读入文件时可用文件，或长方体、圆柱、实体</translation>
    </message>
    <message>
        <source>a stated box or cylinder, as there is no body to lay one around</source>
        <translation>给定的长方体或圆柱，因为没有可供包围的实体</translation>
    </message>
    <message>
        <source>a volume that is not air all over</source>
        <translation>并非全是空气的体积</translation>
    </message>
    <message>
        <source>a closed surface; close its holes</source>
        <translation>封闭的曲面；封闭其孔洞</translation>
    </message>
    <message>
        <source>a table of what the values of the array mean</source>
        <translation>说明数组各值含义的表</translation>
    </message>
    <message>
        <source>a body that a scanline meets; smaller voxels may help</source>
        <translation>有扫描线穿过的实体；减小体素可能有帮助</translation>
    </message>
    <message>
        <source>a first plane below the second</source>
        <translation>第一平面低于第二平面</translation>
    </message>
    <message>
        <source>a formula or table whose values are above 0 all over the layer</source>
        <translation>在整个材料层内值都大于 0 的公式或表</translation>
    </message>
    <message>
        <source>a name that is not empty</source>
        <translation>非空名称</translation>
    </message>
    <message>
        <source>a name that no other layer has</source>
        <translation>其他材料层未使用的名称</translation>
    </message>
    <message>
        <source>planes between which there is stock</source>
        <translation>其间有毛坯的平面</translation>
    </message>
    <message>
        <source>positions that rise</source>
        <translation>递增的位置</translation>
    </message>
    <message>
        <source>the id of a material</source>
        <translation>材料的 ID</translation>
    </message>
    <message>
        <source>the name of one of the material&apos;s values</source>
        <translation>材料某个值的名称</translation>
    </message>
    <message>
        <source>two lines or more, each a position in mm and a value</source>
        <translation>两行或更多，每行为一个位置（mm）和一个值</translation>
    </message>
    <message>
        <source>values that one entry alone has</source>
        <translation>仅一个条目具有的值</translation>
    </message>
    <message>
        <source>a material that is milled needs a value above 0</source>
        <translation>被铣削的材料需要大于 0 的值</translation>
    </message>
    <message>
        <source>a material of your own; those that Burin is shipped with can&apos;t be deleted</source>
        <translation>自建的材料；Burin 自带的材料不能删除</translation>
    </message>
    <message>
        <source>has to be a finite number</source>
        <translation>必须是有限数</translation>
    </message>
    <message>
        <source>has to be letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>必须由字母、数字、“-”、“_”和“.”组成</translation>
    </message>
    <message>
        <source>has to be there</source>
        <translation>必须存在</translation>
    </message>
    <message>
        <source>has to be there, as the other half of Kienzle&apos;s law is</source>
        <translation>必须存在，因为 Kienzle 定律的另一半已存在</translation>
    </message>
    <message>
        <source>has to be there, or Kienzle&apos;s law: without it nothing is felt</source>
        <translation>必须存在，或者有 Kienzle 定律：否则感觉不到任何力</translation>
    </message>
    <message>
        <source>has to be there: feeds and speeds come from it</source>
        <translation>必须存在：进给和转速由它得出</translation>
    </message>
    <message>
        <source>is out of what can be milled</source>
        <translation>超出可铣削的范围</translation>
    </message>
    <message>
        <source>material has to be an id, null or a material</source>
        <translation>材料必须是 ID、null 或材料</translation>
    </message>
    <message>
        <source>has to have a value, or from and to that rise</source>
        <translation>必须有值，或有递增的 from 和 to</translation>
    </message>
    <message>
        <source>has to name a material</source>
        <translation>必须指明一种材料</translation>
    </message>
    <message>
        <source>the same spacing along all axes</source>
        <translation>各轴间距相同</translation>
    </message>
    <message>
        <source>three dimensions</source>
        <translation>三个维度</translation>
    </message>
    <message>
        <source>axes along +X, +Y and +Z</source>
        <translation>沿 +X、+Y 和 +Z 的轴</translation>
    </message>
    <message>
        <source>raw or gzip</source>
        <translation>raw 或 gzip</translation>
    </message>
    <message>
        <source>one file beside the header</source>
        <translation>头文件旁边的一个文件</translation>
    </message>
    <message>
        <source>data that begin at once</source>
        <translation>立即开始的数据</translation>
    </message>
    <message>
        <source>little or big</source>
        <translation>little 或 big</translation>
    </message>
    <message>
        <source>a known material, or one that a new material is like</source>
        <translation>已知材料，或新材料所参照的材料</translation>
    </message>
    <message>
        <source>FlatRadius was read as the radius of the flat: a corner radius of %1 mm.</source>
        <translation>FlatRadius 按平底半径读取：圆角半径为 %1 mm。</translation>
    </message>
    <message>
        <source>The bit has no length of the flutes: %1 mm of %2 were taken.</source>
        <translation>刀具文件没有刃长：采用%2的 %1 mm。</translation>
    </message>
    <message>
        <source>Stick-out, holder, number and limits are those of %1: enter your own.</source>
        <translation>伸出长度、刀柄、编号和限值取自%1：应输入实际值。</translation>
    </message>
    <message>
        <source>The bit has no number of flutes: %1 were taken.</source>
        <translation>刀具文件没有刃数：采用%1。</translation>
    </message>
    <message>
        <source>Length is the stick-out, as far as Burin knows the tool.</source>
        <translation>Length 为伸出长度，以 Burin 对该刀具的了解为限。</translation>
    </message>
    <message>
        <source>Holder, number and limits have no place in a bit and were left out.</source>
        <translation>刀具文件无法存放刀柄、编号和限值，已略去。</translation>
    </message>
    <message>
        <source>Lengths are 0: measure them on the machine.</source>
        <translation>长度为 0：在机床上测量。</translation>
    </message>
    <message>
        <source>a number that no other tool has (%1 has it)</source>
        <translation>其他刀具未使用的编号（%1已使用）</translation>
    </message>
    <message>
        <source>is no number with a unit that is known: &quot;%1&quot;</source>
        <translation>不是带已知单位的数：“%1”</translation>
    </message>
    <message>
        <source>has to be a count from 1 to 100</source>
        <translation>必须是 1 到 100 的个数</translation>
    </message>
    <message>
        <source>has to have a letter or a digit</source>
        <translation>必须含有字母或数字</translation>
    </message>
    <message>
        <source>has to be there, above 0</source>
        <translation>必须存在且大于 0</translation>
    </message>
    <message>
        <source>has to be there, above 0 and below half the diameter</source>
        <translation>必须存在，大于 0 且小于直径的一半</translation>
    </message>
    <message>
        <source>The bit has no TipAngle; 118° is used.</source>
        <translation>刀具文件没有 TipAngle；采用 118°。</translation>
    </message>
    <message>
        <source>1 to 1000: it is the pocket, too</source>
        <translation>1 到 1000：它也是刀库的刀位号</translation>
    </message>
    <message>
        <source>another library (%1)</source>
        <translation>另一个刀具库（%1）</translation>
    </message>
    <message>
        <source>the archive can&apos;t be unpacked</source>
        <translation>无法解压归档文件</translation>
    </message>
    <message>
        <source>a number that no other tool has</source>
        <translation>其他刀具未使用的编号</translation>
    </message>
    <message>
        <source>No tool number: T%1 is used.</source>
        <translation>没有刀具编号：采用 T%1。</translation>
    </message>
    <message>
        <source>No flute length: the one of %1 is used.</source>
        <translation>没有刃长：采用%1的刃长。</translation>
    </message>
    <message>
        <source>No length below the holder: the stick-out of %1 is used.</source>
        <translation>没有刀柄以下长度：采用%1的伸出长度。</translation>
    </message>
    <message>
        <source>The shaft has steps: its largest diameter is used for the whole shank.</source>
        <translation>刀杆有台阶：整个刀杆采用其最大直径。</translation>
    </message>
    <message>
        <source>No holder: the one of %1 is used.</source>
        <translation>没有刀柄：采用%1的刀柄。</translation>
    </message>
    <message>
        <source>Limits and strength are those of %1: enter your own.</source>
        <translation>限值和强度取自%1：应输入实际值。</translation>
    </message>
    <message>
        <source>Expressions were not imported, only the numbers.</source>
        <translation>未导入表达式，仅导入数值。</translation>
    </message>
    <message>
        <source>%1: Burin does not support this shape.</source>
        <translation>%1：Burin 不支持此形状。</translation>
    </message>
    <message>
        <source>%1: Fusion does not support this shape.</source>
        <translation>%1：Fusion 不支持此形状。</translation>
    </message>
    <message>
        <source>%1: CAMotics does not support this shape.</source>
        <translation>%1：CAMotics 不支持此形状。</translation>
    </message>
    <message>
        <source>%1: the diameter is missing.</source>
        <translation>%1：缺少直径。</translation>
    </message>
    <message>
        <source>%1: the tool bit was not found next to the library.</source>
        <translation>%1：在刀具库旁未找到该刀具文件。</translation>
    </message>
    <message>
        <source>%1: CAMotics stores only the cone, not the cylinder above it.</source>
        <translation>%1：CAMotics 只存储圆锥，不存储其上方的圆柱。</translation>
    </message>
    <message>
        <source>Limits, strength and sources of values can&apos;t be stored in this format.</source>
        <translation>此格式无法存储限值、强度和数值来源。</translation>
    </message>
    <message>
        <source>Flutes, shank, holder and limits can&apos;t be stored in this format.</source>
        <translation>此格式无法存储刃数、刀杆、刀柄和限值。</translation>
    </message>
    <message>
        <source>Number of flutes, stick-out, holder and limits are those of %1, and the shank is as wide as the cutter: enter your own.</source>
        <translation>刃数、伸出长度、刀柄和限值取自%1，刀杆与刃部同粗：应输入实际值。</translation>
    </message>
    <message>
        <source>The table gives only number, diameter and name. Everything else is that of %1, and the shank is as wide as the cutter: enter your own.</source>
        <translation>表中只有编号、直径和名称。其余均取自%1，刀杆与刃部同粗：应输入实际值。</translation>
    </message>
    <message>
        <source>it has no stroke</source>
        <translation>它没有笔画</translation>
    </message>
    <message>
        <source>at most the cutter&apos;s radius, %1 mm</source>
        <translation>不大于刀具半径，%1 mm</translation>
    </message>
    <message>
        <source>below the top of what is to be taken away, %1 mm</source>
        <translation>低于待去除部分的顶面，%1 mm</translation>
    </message>
    <message>
        <source>below the top, %1</source>
        <translation>低于顶面，%1</translation>
    </message>
    <message>
        <source>a part to lay rows on; there is none</source>
        <translation>可在其上布置刀路行的零件；目前没有</translation>
    </message>
    <message>
        <source>a part to go along; there is none</source>
        <translation>可沿其走刀的零件；目前没有</translation>
    </message>
    <message>
        <source>less than the rounding of the tool&apos;s end, %1 mm</source>
        <translation>小于刀具端部的圆角，%1 mm</translation>
    </message>
    <message>
        <source>a tool with a rounded end; give a step-over for this one</source>
        <translation>端部为圆形的刀具；此刀具需给定行距</translation>
    </message>
    <message>
        <source>rings of 3 corners at least</source>
        <translation>至少 3 个角点的环</translation>
    </message>
    <message>
        <source>places within 1e5 mm</source>
        <translation>1e5 mm 以内的位置</translation>
    </message>
    <message>
        <source>an area: there is no pocket without one</source>
        <translation>区域：没有区域就没有型腔</translation>
    </message>
    <message>
        <source>lines of 2 places at least</source>
        <translation>至少 2 个位置的线</translation>
    </message>
    <message>
        <source>a line at least: a stroke or curves of a file</source>
        <translation>至少一条线：笔画或文件中的曲线</translation>
    </message>
    <message>
        <source>it is a binary DXF; save it as ASCII</source>
        <translation>是二进制 DXF；另存为 ASCII</translation>
    </message>
    <message>
        <source>it is neither a DXF nor an SVG drawing</source>
        <translation>既不是 DXF 图也不是 SVG 图</translation>
    </message>
    <message>
        <source>there is no curve in it</source>
        <translation>其中没有曲线</translation>
    </message>
    <message>
        <source>it is larger than 64 MB</source>
        <translation>大于 64 MB</translation>
    </message>
    <message>
        <source>a closed curve at least, as border of an area</source>
        <translation>至少一条封闭曲线，作为区域的边界</translation>
    </message>
    <message>
        <source>its curves</source>
        <translation>其曲线</translation>
    </message>
    <message>
        <source>ends before its EOF</source>
        <translation>在 EOF 之前结束</translation>
    </message>
    <message>
        <source>line %1: a group code was expected</source>
        <translation>第%1行：应为组码</translation>
    </message>
    <message>
        <source>has a place farther than 1e5 mm from its origin</source>
        <translation>有位置离原点超过 1e5 mm</translation>
    </message>
    <message>
        <source>has more than two million places</source>
        <translation>位置超过两百万个</translation>
    </message>
    <message>
        <source>has a point that is too far, or too many of them</source>
        <translation>有点太远，或点太多</translation>
    </message>
    <message>
        <source>its viewBox can&apos;t be read</source>
        <translation>其 viewBox 无法读取</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a transform that can&apos;t be read</source>
        <translation>字节%1：&lt;%2&gt; 的 transform 无法读取</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a length &quot;%3&quot; that can&apos;t be read</source>
        <translation>字节%1：&lt;%2&gt; 的长度“%3”无法读取</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has points that can&apos;t be read</source>
        <translation>字节%1：&lt;%2&gt; 的点无法读取</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a path that does not begin with M</source>
        <translation>字节%1：&lt;%2&gt; 的路径不以 M 开头</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a path with numbers behind Z</source>
        <translation>字节%1：&lt;%2&gt; 的路径在 Z 之后有数字</translation>
    </message>
    <message>
        <source>byte %1: &lt;%2&gt; has a path with wrong numbers behind %3</source>
        <translation>字节%1：&lt;%2&gt; 的路径在%3之后有错误的数字</translation>
    </message>
    <message>
        <source>figures that do not lie in the XY plane are left out</source>
        <translation>已略去不在 XY 平面内的图形</translation>
    </message>
    <message>
        <source>a mesh of polygons is left out</source>
        <translation>已略去多边形网格</translation>
    </message>
    <message>
        <source>a spline that states fit points alone is left out</source>
        <translation>已略去只给出拟合点的样条</translation>
    </message>
    <message>
        <source>a spline with wrong knots or weights is left out</source>
        <translation>已略去节点或权重错误的样条</translation>
    </message>
    <message>
        <source>a block that the file does not define is left out</source>
        <translation>已略去文件中未定义的块</translation>
    </message>
    <message>
        <source>blocks within blocks deeper than 16 are left out</source>
        <translation>已略去嵌套深度超过 16 的块</translation>
    </message>
    <message>
        <source>more than 100,000 blocks are left out</source>
        <translation>已略去超过 100,000 个的块</translation>
    </message>
    <message>
        <source>elements nested deeper than 100 are left out</source>
        <translation>已略去嵌套深度超过 100 的元素</translation>
    </message>
    <message>
        <source>&lt;use&gt; of another file is left out</source>
        <translation>已略去引用其他文件的 &lt;use&gt;</translation>
    </message>
    <message>
        <source>more than 10,000 &lt;use&gt; are left out</source>
        <translation>已略去超过 10,000 个的 &lt;use&gt;</translation>
    </message>
    <message>
        <source>&lt;use&gt; of something that is not there is left out</source>
        <translation>已略去引用对象不存在的 &lt;use&gt;</translation>
    </message>
    <message>
        <source>%1 is left out</source>
        <translation>已略去%1</translation>
    </message>
    <message>
        <source>%1 recordings and passes</source>
        <translation>%1个录制和走刀</translation>
    </message>
    <message>
        <source>another tool was loaded before it was computed</source>
        <translation>计算完成前装入了另一把刀具</translation>
    </message>
    <message>
        <source>fixtures or keep-out volumes are in the way: move them</source>
        <translation>夹具或禁入区挡路：将其移开</translation>
    </message>
    <message>
        <source>too much stock is in the way of the tool: rough it first, or use a longer tool</source>
        <translation>挡住刀具的毛坯太多：先粗加工，或使用更长的刀具</translation>
    </message>
    <message>
        <source>no stock is left there</source>
        <translation>该处没有剩余毛坯</translation>
    </message>
    <message>
        <source>a part with edges to follow; there is none</source>
        <translation>有可跟随的边的零件；目前没有</translation>
    </message>
    <message>
        <source>the part has no concave edge for this tool there</source>
        <translation>零件在该处没有适合此刀具的凹边</translation>
    </message>
    <message>
        <source>a point on the part, within 1 mm</source>
        <translation>零件上的点，误差 1 mm 以内</translation>
    </message>
    <message>
        <source>a face that is visible from above</source>
        <translation>从上方可见的面</translation>
    </message>
    <message>
        <source>its beginning</source>
        <translation>其起点</translation>
    </message>
    <message>
        <source>the part has no upright hole there that fits this drill and is not drilled yet</source>
        <translation>零件在该处没有适合此钻头且尚未钻削的竖直孔</translation>
    </message>
    <message>
        <source>a round upright hole of the part, or a depth</source>
        <translation>零件的竖直圆孔，或深度</translation>
    </message>
    <message>
        <source>a drill of at most %1 mm for that hole</source>
        <translation>该孔使用不大于 %1 mm 的钻头</translation>
    </message>
    <message>
        <source>the part is in the way of the drill, or the drill is too short</source>
        <translation>零件挡住钻头，或钻头太短</translation>
    </message>
    <message>
        <source>it has no move at feed</source>
        <translation>它没有进给移动</translation>
    </message>
    <message>
        <source>a path has one work offset, and the program uses another one from here on</source>
        <translation>一条刀路只有一个工件偏置，而程序从此处起使用另一个</translation>
    </message>
    <message>
        <source>a record that Burin can&apos;t follow: %1</source>
        <translation>Burin 无法处理的记录：%1</translation>
    </message>
    <message>
        <source>a tool axis other than +Z</source>
        <translation>+Z 以外的刀具轴</translation>
    </message>
    <message>
        <source>numbers are missing</source>
        <translation>缺少数字</translation>
    </message>
    <message>
        <source>a step from a position that is not stated</source>
        <translation>起始位置未给出的增量移动</translation>
    </message>
    <message>
        <source>a move without a feed</source>
        <translation>没有进给的移动</translation>
    </message>
    <message>
        <source>an arc from a position that is not stated</source>
        <translation>起始位置未给出的圆弧</translation>
    </message>
    <message>
        <source>an arc whose ends do not lie on its circle</source>
        <translation>端点不在其圆上的圆弧</translation>
    </message>
    <message>
        <source>an arc about an axis other than Z</source>
        <translation>绕 Z 以外的轴的圆弧</translation>
    </message>
    <message>
        <source>a feed by inverse time</source>
        <translation>反比时间进给</translation>
    </message>
    <message>
        <source>a feed that is not above 0</source>
        <translation>不大于 0 的进给</translation>
    </message>
    <message>
        <source>a spindle speed as surface speed</source>
        <translation>以线速度给出的主轴转速</translation>
    </message>
    <message>
        <source>a spindle speed below 0</source>
        <translation>小于 0 的主轴转速</translation>
    </message>
    <message>
        <source>a unit other than MM and INCHES</source>
        <translation>MM 和 INCHES 以外的单位</translation>
    </message>
    <message>
        <source>a tool number that is not whole</source>
        <translation>非整数的刀具编号</translation>
    </message>
    <message>
        <source>a finite feed and speed</source>
        <translation>有限的进给和转速</translation>
    </message>
    <message>
        <source>a feed beyond 1e9 mm/min</source>
        <translation>超过 1e9 mm/min 的进给</translation>
    </message>
    <message>
        <source>a position more than 1e6 mm away</source>
        <translation>距离超过 1e6 mm 的位置</translation>
    </message>
    <message>
        <source>another take than the one that is scored</source>
        <translation>与被评分录制不同的另一段录制</translation>
    </message>
    <message>
        <source>another take of the setup of take %1</source>
        <translation>与录制 %1 同一装夹的另一段录制</translation>
    </message>
    <message>
        <source>a take made with %1 that path %2 does not have</source>
        <translation>用 %1 录制、且刀路 %2 中没有的录制</translation>
    </message>
    <message>
        <source>one of several sources of path %1</source>
        <translation>刀路 %1 的多个来源之一</translation>
    </message>
    <message>
        <source>each take once</source>
        <translation>每段录制一次</translation>
    </message>
    <message>
        <source>set-feed, then section</source>
        <translation>先 set-feed，后 section</translation>
    </message>
    <message>
        <source>at most %1 1/min, the limit of the tool %2</source>
        <translation>不超过 %1 1/min，即刀具 %2 的极限</translation>
    </message>
    <message>
        <source>a tool that turns</source>
        <translation>旋转的刀具</translation>
    </message>
    <message>
        <source>no feeds, and links at the safe height without ramps: the tool doesn&apos;t turn</source>
        <translation>不设进给，且在安全高度连接、不用斜坡：该刀具不旋转</translation>
    </message>
    <message>
        <source>profile: the tool doesn&apos;t turn</source>
        <translation>profile：该刀具不旋转</translation>
    </message>
    <message>
        <source>%1 to %2 triangles</source>
        <translation>%1 到 %2 个三角形</translation>
    </message>
    <message>
        <source>triangles of the vertices that are there</source>
        <translation>由已有顶点构成的三角形</translation>
    </message>
    <message>
        <source>the height of the model of the shank</source>
        <translation>刀杆模型的高度</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; was left out: no material can be called &quot;%2&quot;.</source>
        <translation>已略去预设“%1”：材料不能以“%2”命名。</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; is for &quot;%2&quot;, a material that Burin does not have: choose its material.</source>
        <translation>预设“%1”适用于“%2”，Burin 没有这种材料：请为其选择材料。</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot;: the step-down of %2 mm was left out, as the tool allows %3 mm.</source>
        <translation>预设“%1”：已略去 %2 mm 的每层切深，因为刀具只允许 %3 mm。</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot;: the step-over of %2 mm was left out, as the tool allows %3 mm.</source>
        <translation>预设“%1”：已略去 %2 mm 的行距，因为刀具只允许 %3 mm。</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; was left out: %2 has to be %3.</source>
        <translation>已略去预设“%1”：%2 必须为：%3。</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot; is for one operation (%2): Burin uses it for all passes.</source>
        <translation>预设“%1”只适用于一种操作（%2）：Burin 将其用于所有走刀。</translation>
    </message>
    <message>
        <source>Preset &quot;%1&quot;: its remarks were not imported.</source>
        <translation>预设“%1”：未导入其备注。</translation>
    </message>
    <message>
        <source>Coolant &quot;%1&quot; of a preset was not imported.</source>
        <translation>未导入预设的冷却方式“%1”。</translation>
    </message>
    <message>
        <source>Feeds of presets for ramps, leads and transitions were not imported.</source>
        <translation>未导入预设中用于斜坡、切入切出和过渡的进给。</translation>
    </message>
    <message>
        <source>Presets of feeds and speeds can&apos;t be stored in this format.</source>
        <translation>此格式无法保存进给和转速预设。</translation>
    </message>
    <message>
        <source>%1: FreeCAD does not support this shape.</source>
        <translation>%1：FreeCAD 不支持此形状。</translation>
    </message>
    <message>
        <source>The bits are in the folder Bit next to the library. FreeCAD finds them if the library itself is in a folder Library next to that folder.</source>
        <translation>刀头在刀具库旁的 Bit 文件夹中。若刀具库本身位于该文件夹旁的 Library 文件夹中，FreeCAD 就能找到它们。</translation>
    </message>
    <message>
        <source>one; several go into *.fctl, *.tbl, *.tools or *.ctbl</source>
        <translation>一把；多把请写入 *.fctl、*.tbl、*.tools 或 *.ctbl</translation>
    </message>
    <message>
        <source>*.fctl, *.fctb, *.tbl, *.tools, *.ctbl or *.json</source>
        <translation>*.fctl、*.fctb、*.tbl、*.tools、*.ctbl 或 *.json</translation>
    </message>
    <message>
        <source>a short line of text other than all, starter and mine, without spaces around it</source>
        <translation>一行简短文字，不能是 all、starter 或 mine，首尾无空格</translation>
    </message>
    <message>
        <source>mine, or a library of your own</source>
        <translation>mine，或您自己的刀具库</translation>
    </message>
    <message>
        <source>a name that no library has yet</source>
        <translation>尚无刀具库使用的名称</translation>
    </message>
    <message>
        <source>at most maximum_depth_of_cut_mm (%1)</source>
        <translation>至多为 maximum_depth_of_cut_mm（%1）</translation>
    </message>
    <message>
        <source>at most half of diameter_mm (%1)</source>
        <translation>至多为 diameter_mm 的一半（%1）</translation>
    </message>
    <message>
        <source>one line of text that is not empty</source>
        <translation>一行非空文字</translation>
    </message>
    <message>
        <source>a name that no other preset of the tool has</source>
        <translation>该刀具的其他预设未使用的名称</translation>
    </message>
    <message>
        <source>take %1, tick %2</source>
        <translation>录制%1，周期%2</translation>
    </message>
    <message>
        <source>pass %1, tick %2</source>
        <translation>走刀%1，周期%2</translation>
    </message>
    <message>
        <source>the part has no upright hole of the thread&apos;s major diameter there</source>
        <translation>零件在那里没有直径等于螺纹大径的竖直孔</translation>
    </message>
    <message>
        <source>a round upright hole of the part</source>
        <translation>零件上的竖直圆孔</translation>
    </message>
    <message>
        <source>a model whose facets are at most %1 mm inside of that hole&apos;s circle</source>
        <translation>面片位于该孔圆内侧不超过 %1 mm 的模型</translation>
    </message>
    <message>
        <source>a thread mill of at most %1 mm for that hole</source>
        <translation>用于该孔、直径不超过 %1 mm 的螺纹铣刀</translation>
    </message>
    <message>
        <source>a thread mill with one tooth for a pitch of %1 mm</source>
        <translation>适用于螺距 %1 mm 的单齿螺纹铣刀</translation>
    </message>
    <message>
        <source>a thread mill with a neck of at most %1 mm</source>
        <translation>颈部直径不超过 %1 mm 的螺纹铣刀</translation>
    </message>
    <message>
        <source>a thread mill</source>
        <translation>螺纹铣刀</translation>
    </message>
    <message>
        <source>a drill</source>
        <translation>钻头</translation>
    </message>
    <message>
        <source>0 for a thread</source>
        <translation>螺纹为 0</translation>
    </message>
    <message>
        <source>below half of the diameter</source>
        <translation>小于直径的一半</translation>
    </message>
    <message>
        <source>a value for each parameter</source>
        <translation>每个参数一个值</translation>
    </message>
    <message>
        <source>a finite angle</source>
        <translation>有限的角度</translation>
    </message>
    <message>
        <source>a length of %1 to %2 mm</source>
        <translation>%1 至 %2 mm 的长度</translation>
    </message>
    <message>
        <source>a device with axes to assign</source>
        <translation>轴可以分配的设备</translation>
    </message>
    <message>
        <source>low end, rest and high end in ascending order, from -4 to 4</source>
        <translation>下端、静止位置和上端按升序排列，范围为 -4 至 4</translation>
    </message>
    <message>
        <source>the holes are not drilled as deep as the thread: drill them first, with the full diameter down to Z %1 mm in the coordinates of the setup</source>
        <translation>孔没有钻到螺纹的深度：请先钻孔，全直径钻至装夹坐标系的 Z %1 mm</translation>
    </message>
    <message>
        <source>above %1 and at most %2 mm for the hole at %3, %4</source>
        <translation>对于位于 %3, %4 的孔，须大于 %1 mm 且不超过 %2 mm</translation>
    </message>
    <message>
        <source>inside the profile: make the tool from its models again</source>
        <translation>在轮廓之内：请由模型重新生成刀具</translation>
    </message>
    <message>
        <source>inside the shank: make the tool from its models again</source>
        <translation>在刀杆之内：请由模型重新生成刀具</translation>
    </message>
    <message>
        <source>required without chip_load_mm, not allowed with it</source>
        <translation>没有 chip_load_mm 时必须有，有 chip_load_mm 时不得有</translation>
    </message>
    <message>
        <source>%1 mm or more for the other sizes of this fixture</source>
        <translation>在此夹具的其他尺寸下不小于 %1 mm</translation>
    </message>
    <message>
        <source>a moment that is still in the path</source>
        <translation>刀路中仍存在的时刻</translation>
    </message>
    <message>
        <source>a hole modelled with the major diameter, %1 mm, not with %2 mm</source>
        <translation>按大径 %1 mm（而非 %2 mm）建模的孔</translation>
    </message>
    <message>
        <source>at least one button that mills</source>
        <translation>至少有一个按钮用于铣削</translation>
    </message>
    <message>
        <source>Step-down, step-over and coolant of presets can&apos;t be stored in a FreeCAD tool bit.</source>
        <translation>FreeCAD 刀头无法保存预设的每层切深、行距和冷却方式。</translation>
    </message>
    <message>
        <source>Holders and limits can&apos;t be stored in a FreeCAD library and were left out.</source>
        <translation>FreeCAD 刀具库无法保存刀柄和限值，已略去。</translation>
    </message>
    <message>
        <source>profile: the tip is hollow</source>
        <translation>profile：刀尖是空心的</translation>
    </message>
    <message>
        <source>a tool without a hollow</source>
        <translation>没有空腔的刀具</translation>
    </message>
    <message>
        <source>3 corners or more in each ring</source>
        <translation>每个环至少 3 个角点</translation>
    </message>
    <message>
        <source>at most %1 corners</source>
        <translation>最多 %1 个角点</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>一块面积</translation>
    </message>
    <message>
        <source>has to hold a ring at least</source>
        <translation>至少要包含一个环</translation>
    </message>
    <message>
        <source>another one during a recording</source>
        <translation>录制期间须为其他层</translation>
    </message>
    <message>
        <source>a tip from which the tool is clear of the stock</source>
        <translation>刀尖所在位置的刀具不接触毛坯</translation>
    </message>
    <message>
        <source>a tip from which the tool meets the stock in this direction</source>
        <translation>刀具从该刀尖位置沿此方向能碰到毛坯</translation>
    </message>
    <message>
        <source>strokes of the hand have finished the part there</source>
        <translation>手动笔画已将那里的零件精加工</translation>
    </message>
    <message>
        <source>a stroke of the hand before it in its path that has finished the part</source>
        <translation>其刀路中在它之前、已精加工零件的手动笔画</translation>
    </message>
    <message>
        <source>ignore: only passes on the surface of the part heed strokes of the hand</source>
        <translation>ignore：只有零件表面上的走刀会顾及手动笔画</translation>
    </message>
    <message>
        <source>ignore, keep-off or blend; only flow extends strokes of the hand</source>
        <translation>ignore、keep-off 或 blend；只有 flow 能延续手动笔画</translation>
    </message>
    <message>
        <source>no lines to follow: the rows follow the strokes of the path</source>
        <translation>不带引导线：各行跟随刀路的笔画</translation>
    </message>
    <message>
        <source>keep-off, blend or extend</source>
        <translation>keep-off、blend 或 extend</translation>
    </message>
    <message>
        <source>at most %1, the number of lines</source>
        <translation>不超过%1，即线的数量</translation>
    </message>
    <message>
        <source>a stroke is undone or redone there that the trace does not contain</source>
        <translation>此处撤销或重做的笔画不在该轨迹中</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>第%1个读数</translation>
    </message>
    <message>
        <source>one that the session has</source>
        <translation>会话所具有的图层</translation>
    </message>
    <message>
        <source>a workpiece with material</source>
        <translation>含有材料的工件</translation>
    </message>
    <message>
        <source>the disk could not keep up</source>
        <translation>磁盘速度跟不上</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>one that was recorded with the fixtures, keep-out volumes and machine of this project</source>
        <translation>使用本项目的夹具、禁入区和机床录制的轨迹</translation>
    </message>
    <message>
        <source>a stock with a surface</source>
        <translation>有表面的毛坯</translation>
    </message>
    <message>
        <source>a rotation by a multiple of 90 degrees: the edges of a box stay parallel to the axes</source>
        <translation>旋转 90 度的整数倍：长方体的棱边始终平行于坐标轴</translation>
    </message>
    <message>
        <source>a rotation about Z: the fixture stands upright</source>
        <translation>绕 Z 轴旋转：夹具保持直立</translation>
    </message>
    <message>
        <source>the studs are milled to %1 mm, too narrow for the thread&apos;s major diameter, %2 mm</source>
        <translation>凸台已铣至 %1 mm，小于螺纹大径 %2 mm</translation>
    </message>
    <message>
        <source>the stock around the studs is in the way: mill it to the thread&apos;s major diameter first, %1 mm, down to Z %2 mm in the coordinates of the setup</source>
        <translation>凸台周围的材料挡住了刀具：请先将其铣至螺纹大径 %1 mm，深至装夹坐标系的 Z %2 mm</translation>
    </message>
    <message>
        <source>the part is in the way of the tool around its studs, or it is too short</source>
        <translation>零件在凸台周围挡住了刀具，或刀具太短</translation>
    </message>
    <message>
        <source>the part has no upright stud of the thread&apos;s minor diameter there</source>
        <translation>零件在该处没有直径等于螺纹小径的竖直凸台</translation>
    </message>
    <message>
        <source>a round upright stud of the part</source>
        <translation>零件的竖直圆凸台</translation>
    </message>
    <message>
        <source>a stud modelled with the minor diameter that this mill cuts, %1 mm, not with %2 mm</source>
        <translation>按此铣刀所铣小径 %1 mm（而非 %2 mm）建模的凸台</translation>
    </message>
    <message>
        <source>above %1 and at most %2 mm for the stud at %3, %4</source>
        <translation>对于 %3, %4 处的凸台：大于 %1 且至多 %2 mm</translation>
    </message>
    <message>
        <source>above 0, or the holes or studs of the thread</source>
        <translation>大于 0，或指定螺纹的孔或凸台</translation>
    </message>
    <message>
        <source>has to be above low_deg</source>
        <translation>必须大于 low_deg</translation>
    </message>
    <message>
        <source>has to leave 0 within the limits</source>
        <translation>必须使 0 位于极限之内</translation>
    </message>
    <message>
        <source>has to be A or B, or two different axes of which A or B is the second</source>
        <translation>必须是 A 或 B，或两个不同的轴，其中第二个为 A 或 B</translation>
    </message>
    <message>
        <source>has to be synchronised or tip with rotary_axes</source>
        <translation>有 rotary_axes 时必须是 synchronised 或 tip</translation>
    </message>
    <message>
        <source>link, then tool-axis</source>
        <translation>先 link，再 tool-axis</translation>
    </message>
    <message>
        <source>a machine with rotary axes</source>
        <translation>有旋转轴的机床</translation>
    </message>
    <message>
        <source>programs of X, Y and Z</source>
        <translation>只有 X、Y、Z 的程序</translation>
    </message>
    <message>
        <source>tools that turn and are not hollow, unlike %1</source>
        <translation>旋转且不是空心的刀具，与 %1 不同</translation>
    </message>
    <message>
        <source>moves of a ball end mill, or upright ones</source>
        <translation>球头铣刀的动作，或竖直的动作</translation>
    </message>
    <message>
        <source>a path of a program that tilts the tool</source>
        <translation>由使刀具倾斜的程序生成的刀路</translation>
    </message>
    <message>
        <source>a part of the path that is no farther than 2 mm from the part</source>
        <translation>距零件不超过 2 mm 的一段刀路</translation>
    </message>
    <message>
        <source>the tool comes %1 too near to the part at %2</source>
        <translation>刀具在 %2 处离零件过近，相差 %1</translation>
    </message>
    <message>
        <source>the tool comes %1 too near to a fixture at %2</source>
        <translation>刀具在 %2 处离夹具过近，相差 %1</translation>
    </message>
    <message>
        <source>a tool axis that the machine can&apos;t reach</source>
        <translation>机床无法达到的刀轴方向</translation>
    </message>
    <message>
        <source>a tool axis that is not of unit length</source>
        <translation>长度不为 1 的刀轴向量</translation>
    </message>
    <message>
        <source>a tilted tool axis; paths tilt ball end mills only</source>
        <translation>倾斜的刀轴；刀路只能倾斜球头铣刀</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>simulated: no force is felt; values of a 3D Systems Touch (CHAI3D device table) scale the force that is shown</source>
        <translation>模拟：感觉不到力；所显示的力按 3D Systems Touch 的参数（CHAI3D 设备表）缩放</translation>
    </message>
    <message>
        <source>The cap sets the speed</source>
        <translation>控制帽决定速度</translation>
    </message>
    <message>
        <source>The cap sets the position</source>
        <translation>控制帽决定位置</translation>
    </message>
    <message>
        <source>CHAI3D 3.3, table of devices</source>
        <translation>CHAI3D 3.3，设备表</translation>
    </message>
    <message>
        <source>the device itself</source>
        <translation>设备本身</translation>
    </message>
    <message>
        <source>CHAI3D 3.3, table of devices: Premium 6DOF</source>
        <translation>CHAI3D 3.3，设备表：Premium 6DOF</translation>
    </message>
    <message>
        <source>Haply&apos;s tutorial</source>
        <translation>Haply 教程</translation>
    </message>
    <message>
        <source>one message of the service</source>
        <translation>服务的一条消息</translation>
    </message>
    <message>
        <source>Calibrated devices only</source>
        <translation>仅限已标定的设备</translation>
    </message>
    <message>
        <source>Self-calibrating: the device moves by itself</source>
        <translation>自动标定：设备会自行移动</translation>
    </message>
    <message>
        <source>conservative estimate</source>
        <translation>保守估计</translation>
    </message>
    <message>
        <source>set by Burin</source>
        <translation>由 Burin 设定</translation>
    </message>
    <message>
        <source>right</source>
        <translation>向右</translation>
    </message>
    <message>
        <source>towards the user</source>
        <translation>朝向用户</translation>
    </message>
    <message>
        <source>down</source>
        <translation>向下</translation>
    </message>
    <message>
        <source>tilt back and forth</source>
        <translation>前后倾斜</translation>
    </message>
    <message>
        <source>tilt sideways</source>
        <translation>左右倾斜</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>扭转</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>RX</source>
        <translation>RX</translation>
    </message>
    <message>
        <source>RY</source>
        <translation>RY</translation>
    </message>
    <message>
        <source>RZ</source>
        <translation>RZ</translation>
    </message>
    <message>
        <source>hat X</source>
        <translation>苦力帽 X</translation>
    </message>
    <message>
        <source>hat Y</source>
        <translation>苦力帽 Y</translation>
    </message>
    <message>
        <source>throttle</source>
        <translation>油门杆</translation>
    </message>
    <message>
        <source>rudder</source>
        <translation>方向舵</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>方向盘</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>油门</translation>
    </message>
    <message>
        <source>position to the right</source>
        <translation>位置（向右）</translation>
    </message>
    <message>
        <source>position away from the user</source>
        <translation>位置（远离用户）</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>tilt to the right</source>
        <translation>倾斜（向右）</translation>
    </message>
    <message>
        <source>tilt away from the user</source>
        <translation>倾斜（远离用户）</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>刹车</translation>
    </message>
</context>
<context>
    <name>DeviceLabels</name>
    <message>
        <source>Position: X %1, Y %2, Z %3 mm</source>
        <translation>位置：X %1，Y %2，Z %3 mm</translation>
    </message>
    <message>
        <source>Buttons pressed: %1</source>
        <translation>按下的按钮：%1</translation>
    </message>
    <message>
        <source>Battery: %1 %</source>
        <translation>电池：%1 %</translation>
    </message>
    <message>
        <source>Rate: %1 Hz; interval: median %2 ms, maximum %3 ms</source>
        <translation>频率：%1 Hz；间隔：中位数 %2 ms，最大 %3 ms</translation>
    </message>
    <message>
        <source>Maximum force commanded: %1 N</source>
        <translation>最大指令力：%1 N</translation>
    </message>
    <message>
        <source>Motor temperature: %1 % of the limit</source>
        <translation>电机温度：限值的 %1 %</translation>
    </message>
    <message>
        <source>Invalid readings: %1</source>
        <translation>无效读数：%1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>maximum force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>continuous force</source>
        <translation>连续力</translation>
    </message>
    <message>
        <source>maximum torque</source>
        <translation>最大扭矩</translation>
    </message>
    <message>
        <source>maximum stiffness</source>
        <translation>最大刚度</translation>
    </message>
    <message>
        <source>maximum damping</source>
        <translation>最大阻尼</translation>
    </message>
    <message>
        <source>maximum rotational stiffness</source>
        <translation>最大旋转刚度</translation>
    </message>
    <message>
        <source>workspace radius</source>
        <translation>工作空间半径</translation>
    </message>
    <message>
        <source>position step</source>
        <translation>位置分辨率</translation>
    </message>
    <message>
        <source>rotation step</source>
        <translation>角度分辨率</translation>
    </message>
    <message>
        <source>maximum speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>mass of the handle</source>
        <translation>手柄质量</translation>
    </message>
    <message>
        <source>axes: %1 sensed, %2 driven; buttons: %3</source>
        <translation>轴：检测%1，驱动%2；按钮：%3</translation>
    </message>
    <message>
        <source>Motion: %1 × %2 × %3 mm; smallest step %4 mm</source>
        <translation>移动：%1 × %2 × %3 mm；最小步长 %4 mm</translation>
    </message>
    <message>
        <source>Rotation: %1°</source>
        <translation>旋转：%1°</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>X, right</source>
        <translation>X，向右</translation>
    </message>
    <message>
        <source>Y, away</source>
        <translation>Y，远离用户</translation>
    </message>
    <message>
        <source>Z, up</source>
        <translation>Z，向上</translation>
    </message>
    <message>
        <source>A, about X</source>
        <translation>A，绕 X</translation>
    </message>
    <message>
        <source>B, about Y</source>
        <translation>B，绕 Y</translation>
    </message>
    <message>
        <source>C, about Z</source>
        <translation>C，绕 Z</translation>
    </message>
    <message>
        <source>mill</source>
        <translation>铣削</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>抬刀</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>clutch</source>
        <translation>离合</translation>
    </message>
    <message>
        <source>recentre</source>
        <translation>回中</translation>
    </message>
    <message>
        <source>level above</source>
        <translation>上一层</translation>
    </message>
    <message>
        <source>level below</source>
        <translation>下一层</translation>
    </message>
    <message>
        <source>nearest edge</source>
        <translation>最近的边</translation>
    </message>
    <message>
        <source>fit the view</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>button %1: %2</source>
        <translation>按钮 %1：%2</translation>
    </message>
    <message>
        <source>%1: %2, reversed; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %</source>
        <translation>%1：%2，反向；增益 %3；死区 %4 %；范围 %5 至 %7 %，静止 %6 %</translation>
    </message>
    <message>
        <source>%1: %2; gain %3; dead zone %4 %; range %5 to %7 %, rest %6 %</source>
        <translation>%1：%2；增益 %3；死区 %4 %；范围 %5 至 %7 %，静止 %6 %</translation>
    </message>
    <message>
        <source>assist: vibrates</source>
        <translation>辅助：振动</translation>
    </message>
    <message>
        <source>assist: pushes 1 axis of its stick, too weakly to hold the hand</source>
        <translation>辅助：推动摇杆的 1 个轴，力太弱，挡不住手</translation>
    </message>
    <message>
        <source>assist: pushes %1 axes of its stick, too weakly to hold the hand</source>
        <translation>辅助：推动摇杆的 %1 个轴，力太弱，挡不住手</translation>
    </message>
    <message>
        <source>assist: off, as you have no permission to write to the device; install Burin&apos;s udev rule and plug it in again</source>
        <translation>辅助：关闭，因为没有写入该设备的权限；安装 Burin 的 udev 规则后重新插入设备</translation>
    </message>
    <message>
        <source>Maximum strength commanded: %1 %</source>
        <translation>最大指令强度：%1 %</translation>
    </message>
    <message>
        <source>99 of 100 intervals are shorter than %1 ms</source>
        <translation>100 个间隔中有 99 个短于 %1 ms</translation>
    </message>
    <message>
        <source>Latency from reading to force: at most %1 ms</source>
        <translation>从读数到力的延迟：最多 %1 ms</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by %2 ms between readings</source>
        <translation>建议刚度：%1 N/mm，受读数间隔 %2 ms 限制</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by readings up to %2 ms late</source>
        <translation>建议刚度：%1 N/mm，受最多迟到 %2 ms 的读数限制</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by %2 ms latency</source>
        <translation>建议刚度：%1 N/mm，受 %2 ms 延迟限制</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by steps of %2 mm at %3 N of friction</source>
        <translation>建议刚度：%1 N/mm，受 %2 mm 的步距和 %3 N 的摩擦限制</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by your own maximum</source>
        <translation>建议刚度：%1 N/mm，受您设定的最大值限制</translation>
    </message>
    <message>
        <source>Suggested stiffness: %1 N/mm, limited by the device itself</source>
        <translation>建议刚度：%1 N/mm，受设备本身限制</translation>
    </message>
    <message>
        <source>Suggested damping: %1 N·s/m</source>
        <translation>建议阻尼：%1 N·s/m</translation>
    </message>
    <message>
        <source>Safety margin: %1 % below what is stable for a handle that nobody holds</source>
        <translation>安全裕量：比无人握持手柄时的稳定极限低 %1 %</translation>
    </message>
    <message>
        <source>Latency: %1 ms, as the device states; not measured</source>
        <translation>延迟：%1 ms，由设备声明，未测量</translation>
    </message>
    <message>
        <source>Latency: unknown, as the device neither states nor reports it</source>
        <translation>延迟：未知，设备既未声明也未报告</translation>
    </message>
    <message>
        <source>In use: stiffness up to %1 N/mm, damping up to %2 N·s/m</source>
        <translation>使用中：刚度不超过 %1 N/mm，阻尼不超过 %2 N·s/m</translation>
    </message>
    <message>
        <source>In use: stiffness up to %1 N/mm, damping of the device</source>
        <translation>使用中：刚度不超过 %1 N/mm，阻尼取自设备</translation>
    </message>
    <message>
        <source>In use: stiffness and damping of the device</source>
        <translation>使用中：刚度和阻尼取自设备</translation>
    </message>
</context>
<context>
    <name>DeviceReason</name>
    <message>
        <source>it is not plugged in</source>
        <translation>未插入</translation>
    </message>
    <message>
        <source>it sends nothing</source>
        <translation>不发送任何数据</translation>
    </message>
    <message>
        <source>it is not calibrated yet</source>
        <translation>尚未标定</translation>
    </message>
    <message>
        <source>its motors are too hot</source>
        <translation>电机过热</translation>
    </message>
    <message>
        <source>its motors were overloaded</source>
        <translation>电机过载</translation>
    </message>
    <message>
        <source>it moved too fast</source>
        <translation>移动过快</translation>
    </message>
    <message>
        <source>its stop button is pressed</source>
        <translation>停止按钮已按下</translation>
    </message>
    <message>
        <source>a sensor or a drive failed</source>
        <translation>传感器或驱动器失效</translation>
    </message>
    <message>
        <source>it does not identify itself</source>
        <translation>未表明自己的身份</translation>
    </message>
    <message>
        <source>its limits are out of range</source>
        <translation>限值超出范围</translation>
    </message>
    <message>
        <source>the computer was late with its force</source>
        <translation>计算机给出力过迟</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>数据已损坏</translation>
    </message>
    <message>
        <source>it does not accept data</source>
        <translation>不接收数据</translation>
    </message>
    <message>
        <source>it received nothing from the computer for too long</source>
        <translation>太久未收到计算机的数据</translation>
    </message>
    <message>
        <source>the computer did not respond, so its motors were switched off</source>
        <translation>计算机未响应，因此电机已关闭</translation>
    </message>
    <message>
        <source>another program uses it</source>
        <translation>正被另一程序使用</translation>
    </message>
    <message>
        <source>OpenHaptics has no licence</source>
        <translation>OpenHaptics 没有许可证</translation>
    </message>
    <message>
        <source>its model is not supported</source>
        <translation>型号不受支持</translation>
    </message>
    <message>
        <source>it is not calibrated; choose its self-calibrating mode</source>
        <translation>未标定；选择自动标定模式</translation>
    </message>
    <message>
        <source>put its stylus into the inkwell to calibrate it</source>
        <translation>将触笔插入笔座以标定</translation>
    </message>
</context>
<context>
    <name>Edit</name>
    <message>
        <source>Drop air cuts</source>
        <translation>去除空切</translation>
    </message>
    <message>
        <source>Drop dwells</source>
        <translation>去除暂停</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Keep out of the part</source>
        <translation>避开零件</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>简化</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Set feed and speed</source>
        <translation>设置进给和转速</translation>
    </message>
    <message>
        <source>Smooth by a spline in time (earlier version)</source>
        <translation>按时间样条平滑（旧版）</translation>
    </message>
    <message>
        <source>Delete part of the path</source>
        <translation>删除部分刀路</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>修剪</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>拆分</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>合并</translation>
    </message>
    <message>
        <source>Reorder</source>
        <translation>重新排序</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Move points</source>
        <translation>移动点</translation>
    </message>
    <message>
        <source>Replace part of the path</source>
        <translation>替换部分刀路</translation>
    </message>
    <message>
        <source>Delete in an area</source>
        <translation>删除区域内刀路</translation>
    </message>
    <message>
        <source>Retract in an area</source>
        <translation>区域内抬刀</translation>
    </message>
    <message>
        <source>Project onto the part</source>
        <translation>投影到零件</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Rows along a guide</source>
        <translation>沿导向的刀路行</translation>
    </message>
    <message>
        <source>Fit arcs</source>
        <translation>拟合圆弧</translation>
    </message>
    <message>
        <source>Round corners</source>
        <translation>圆角过渡</translation>
    </message>
    <message>
        <source>Lead in</source>
        <translation>切入</translation>
    </message>
    <message>
        <source>Lead out</source>
        <translation>切出</translation>
    </message>
    <message>
        <source>Feed by engagement</source>
        <translation>按吃刀量调整进给</translation>
    </message>
    <message>
        <source>Feed in an area</source>
        <translation>区域内进给</translation>
    </message>
    <message>
        <source>Smooth in time (earlier version)</source>
        <translation>按时间平滑（旧版）</translation>
    </message>
    <message>
        <source>Feed of strokes</source>
        <translation>笔画进给</translation>
    </message>
    <message>
        <source>Extend</source>
        <translation>延长</translation>
    </message>
    <message>
        <source>Holding tabs</source>
        <translation>连接片</translation>
    </message>
    <message>
        <source>Spindle and coolant</source>
        <translation>主轴与冷却液</translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation>插入点</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>刀轴</translation>
    </message>
</context>
<context>
    <name>EditParameterLabels</name>
    <message>
        <source>Shortest</source>
        <translation>最短长度</translation>
    </message>
    <message>
        <source>Shorter air cuts are kept</source>
        <translation>更短的空切予以保留</translation>
    </message>
    <message>
        <source>Slower than</source>
        <translation>慢于</translation>
    </message>
    <message>
        <source>Tool speed below which the hand counts as resting</source>
        <translation>刀具速度低于此值时视为手静止</translation>
    </message>
    <message>
        <source>Longer than</source>
        <translation>长于</translation>
    </message>
    <message>
        <source>Shorter dwells are kept</source>
        <translation>更短的暂停予以保留</translation>
    </message>
    <message>
        <source>Tremor above it is removed</source>
        <translation>高于此值的抖动将被去除</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Largest deviation from the recording</source>
        <translation>与录制的最大偏差</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Distance from the part, in addition to the allowance</source>
        <translation>与零件的距离，另加余量</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>Distance between the points at which the path is kept out of the part</source>
        <translation>使刀路避开零件的各点之间的距离</translation>
    </message>
    <message>
        <source>Largest deviation of the points that are left out</source>
        <translation>被略去的点的最大偏差</translation>
    </message>
    <message>
        <source>Clearance above</source>
        <translation>安全高度</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>接近高度</translation>
    </message>
    <message>
        <source>Height of rapid moves above the top of the stock</source>
        <translation>快速移动高于毛坯顶面的高度</translation>
    </message>
    <message>
        <source>Height above the remaining stock at which the plunge begins</source>
        <translation>垂直下刀起始处高于剩余毛坯的高度</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n个点</numerusform>
        </translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>适用于</translation>
    </message>
    <message>
        <source>Strokes to edit. Select them in the view first</source>
        <translation>要编辑的笔画。先在视图中选择</translation>
    </message>
    <message>
        <source>Part of the path to delete. Select it in the view first</source>
        <translation>要删除的刀路部分。先在视图中选择</translation>
    </message>
    <message>
        <source>Points that are moved</source>
        <translation>要移动的点</translation>
    </message>
    <message>
        <source>Part of the path that the drawn stroke replaces</source>
        <translation>由所画笔画替换的刀路部分</translation>
    </message>
    <message>
        <source>From the start</source>
        <translation>从起点</translation>
    </message>
    <message>
        <source>Cut off where each stroke begins</source>
        <translation>在每个笔画起点处切除的长度</translation>
    </message>
    <message>
        <source>From the end</source>
        <translation>从终点</translation>
    </message>
    <message>
        <source>Cut off where each stroke ends</source>
        <translation>在每个笔画终点处切除的长度</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>The stroke is split here</source>
        <translation>笔画在此处拆分</translation>
    </message>
    <message>
        <source>Largest gap</source>
        <translation>最大间隙</translation>
    </message>
    <message>
        <source>Ends no farther apart than this are joined</source>
        <translation>相距不超过此值的端点将合并</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>The stroke that is moved in the order</source>
        <translation>要调整顺序的笔画</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>移到其前</translation>
    </message>
    <message>
        <source>The stroke that it comes before; none: it comes last</source>
        <translation>移到此笔画之前；无：排到最后</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>垂直于</translation>
    </message>
    <message>
        <source>Axis perpendicular to the mirror plane</source>
        <translation>垂直于镜像平面的轴</translation>
    </message>
    <message>
        <source>Plane at</source>
        <translation>平面位于</translation>
    </message>
    <message>
        <source>Keep the originals</source>
        <translation>保留原件</translation>
    </message>
    <message>
        <source>They are cut before their images</source>
        <translation>先切削原件，再切削镜像</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Anticlockwise as seen from above</source>
        <translation>俯视逆时针方向</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>From each copy to the next</source>
        <translation>从每个副本到下一个</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>From each copy to the next, anticlockwise as seen from above</source>
        <translation>从每个副本到下一个，俯视逆时针方向</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>副本数</translation>
    </message>
    <message>
        <source>Besides the original</source>
        <translation>不含原件</translation>
    </message>
    <message>
        <source>By</source>
        <translation>移动量</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>衰减范围</translation>
    </message>
    <message>
        <source>Points along the stroke within this distance follow by less and less</source>
        <translation>笔画上此距离内的点随之移动，越远移动越小</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>移动方式</translation>
    </message>
    <message>
        <source>Freely, or along the part&apos;s surface with the same distance from it</source>
        <translation>自由移动，或沿零件表面移动并保持与表面的距离不变</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Points of the drawn stroke</source>
        <translation>所绘笔画的点</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓线</translation>
    </message>
    <message>
        <source>Corners of the area, seen from above</source>
        <translation>区域的各角点（俯视）</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Up to</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>抬刀</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>系数</translation>
    </message>
    <message>
        <source>Feeds inside the area are multiplied by this</source>
        <translation>区域内的进给乘以此系数</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Stock left on the part</source>
        <translation>零件上留下的材料</translation>
    </message>
    <message>
        <source>Distance between the points that are projected onto the part</source>
        <translation>投影到零件上的各点之间的距离</translation>
    </message>
    <message>
        <source>Down the tool&apos;s axis, or along the part&apos;s normal</source>
        <translation>沿刀具轴线向下，或沿零件法线</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>To the left of the motion; negative to the right</source>
        <translation>向运动方向左侧；负值向右侧</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>导向</translation>
    </message>
    <message>
        <source>Points of a drawn guide; none: the selected strokes</source>
        <translation>所绘导向的点；无：所选笔画</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Between rows, seen from above</source>
        <translation>各行之间的距离（俯视）</translation>
    </message>
    <message>
        <source>Rows to the left</source>
        <translation>左侧行数</translation>
    </message>
    <message>
        <source>Beside the guide, in its direction</source>
        <translation>导向旁边，按导向的方向</translation>
    </message>
    <message>
        <source>Rows to the right</source>
        <translation>右侧行数</translation>
    </message>
    <message>
        <source>Largest deviation of an arc from the path</source>
        <translation>圆弧与刀路的最大偏差</translation>
    </message>
    <message>
        <source>Largest sweep</source>
        <translation>最大圆心角</translation>
    </message>
    <message>
        <source>Arcs of a larger angle are split</source>
        <translation>角度更大的圆弧会被分段</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>Largest radius</source>
        <translation>最大半径</translation>
    </message>
    <message>
        <source>Radius mismatch</source>
        <translation>半径偏差</translation>
    </message>
    <message>
        <source>How far the radii at both ends may differ once values are rounded</source>
        <translation>数值取整后，两端半径允许相差多少</translation>
    </message>
    <message>
        <source>Largest deviation of a rounded corner from the sharp one</source>
        <translation>圆角与尖角的最大偏差</translation>
    </message>
    <message>
        <source>Smallest turn</source>
        <translation>最小转角</translation>
    </message>
    <message>
        <source>Strokes that get a lead-in. Select them in the view first</source>
        <translation>要添加切入的笔画。先在视图中选择</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Length of a line or ramp, radius of an arc or helix</source>
        <translation>直线或斜坡的长度，圆弧或螺旋的半径</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Largest descent angle of a helix</source>
        <translation>螺旋的最大下降角度</translation>
    </message>
    <message>
        <source>Length of a line, radius of an arc</source>
        <translation>直线的长度，圆弧的半径</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>均衡</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标值</translation>
    </message>
    <message>
        <source>Smallest chip</source>
        <translation>最小切屑</translation>
    </message>
    <message>
        <source>A tooth never takes less</source>
        <translation>每齿切下的不少于此值</translation>
    </message>
    <message>
        <source>Largest chip</source>
        <translation>最大切屑</translation>
    </message>
    <message>
        <source>A tooth never takes more</source>
        <translation>每齿切下的不多于此值</translation>
    </message>
    <message>
        <source>Least change</source>
        <translation>最小变化</translation>
    </message>
    <message>
        <source>Change of the feed; smaller changes are left out</source>
        <translation>进给的变化；更小的变化会略去</translation>
    </message>
    <message>
        <source>Distance between the points at which moves are evaluated</source>
        <translation>对移动进行计算的各点之间的距离</translation>
    </message>
    <message>
        <source>a straight line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>an arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>a ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>a helix</source>
        <translation>螺旋</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>freely</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>the part&apos;s surface</source>
        <translation>零件表面</translation>
    </message>
    <message>
        <source>the tool&apos;s axis</source>
        <translation>刀具轴线</translation>
    </message>
    <message>
        <source>the part&apos;s normal</source>
        <translation>零件法线</translation>
    </message>
    <message>
        <source>full height</source>
        <translation>完全抬起</translation>
    </message>
    <message>
        <source>lowest safe height</source>
        <translation>最低安全高度</translation>
    </message>
    <message>
        <source>the force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>the removal rate</source>
        <translation>材料去除率</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>Chip load</source>
        <translation>每齿进给量</translation>
    </message>
    <message>
        <source>Share of the table value; feeds change with it</source>
        <translation>占表中数值的比例；进给随之变化</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>冷却液</translation>
    </message>
    <message>
        <source>as advised</source>
        <translation>按建议</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>mist (M7)</source>
        <translation>喷雾 (M7)</translation>
    </message>
    <message>
        <source>flood (M8)</source>
        <translation>浇注 (M8)</translation>
    </message>
    <message>
        <source>Retract: full height, lowest safe height, or around obstacles</source>
        <translation>抬刀：完全抬起、最低安全高度，或绕过障碍物</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>倒圆</translation>
    </message>
    <message>
        <source>Largest length of either move that a rounded corner of a link may replace; none: sharp corners</source>
        <translation>连接的圆角可在两段移动上各自替换的最大长度；无：保持尖角</translation>
    </message>
    <message>
        <source>around obstacles</source>
        <translation>绕过障碍物</translation>
    </message>
    <message>
        <source>0: the mean of the path&apos;s cutting moves</source>
        <translation>0：刀路各切削移动的平均值</translation>
    </message>
    <message>
        <source>Position of the mirror plane, from program zero; it can be drawn in the view, as a line</source>
        <translation>镜像平面的位置，从程序零点算起；可在视图中画一条线来确定</translation>
    </message>
    <message>
        <source>Position of the vertical axis of rotation, from program zero</source>
        <translation>竖直旋转轴的位置，从程序零点算起</translation>
    </message>
    <message>
        <source>Lowest height of the area, from program zero</source>
        <translation>区域的最低高度，从程序零点算起</translation>
    </message>
    <message>
        <source>Greatest height of the area, from program zero</source>
        <translation>区域的最高高度，从程序零点算起</translation>
    </message>
    <message>
        <source>Cut-off wavelength</source>
        <translation>截止波长</translation>
    </message>
    <message>
        <source>Tremor across the path with a shorter wavelength is removed</source>
        <translation>去除垂直于刀路、波长更短的抖动</translation>
    </message>
    <message>
        <source>Cut-off frequency</source>
        <translation>截止频率</translation>
    </message>
    <message>
        <source>within the limits alone</source>
        <translation>仅限制在极限之内</translation>
    </message>
    <message>
        <source>Into material</source>
        <translation>切入材料</translation>
    </message>
    <message>
        <source>Ramp angle</source>
        <translation>斜坡角度</translation>
    </message>
    <message>
        <source>Largest descent angle of ramps and helices; 0: by material and tool</source>
        <translation>斜坡和螺旋的最大下降角度；0：按材料和刀具</translation>
    </message>
    <message>
        <source>Direction by</source>
        <translation>方向依据</translation>
    </message>
    <message>
        <source>By the recording, leads keep their side when other edits change</source>
        <translation>依据录制时，其他编辑步骤改变后，切入和切出仍保持在原来一侧</translation>
    </message>
    <message>
        <source>straight down</source>
        <translation>垂直向下</translation>
    </message>
    <message>
        <source>a ramp or helix</source>
        <translation>斜坡或螺旋</translation>
    </message>
    <message>
        <source>the first move</source>
        <translation>第一段移动</translation>
    </message>
    <message>
        <source>the recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Curves with a smaller radius stay straight moves</source>
        <translation>半径更小的曲线保持为直线移动</translation>
    </message>
    <message>
        <source>Curves with a larger radius stay straight moves</source>
        <translation>半径更大的曲线保持为直线移动</translation>
    </message>
    <message>
        <source>Corners with a smaller angle are kept</source>
        <translation>角度更小的拐角保持不变</translation>
    </message>
    <message>
        <source>Motion onto the stroke, or away from it</source>
        <translation>进入笔画或离开笔画的运动</translation>
    </message>
    <message>
        <source>Height of a ramp or helix</source>
        <translation>斜坡或螺旋的高度</translation>
    </message>
    <message>
        <source>Entry into a stroke that begins in material: plunge, or a ramp along the stroke, else a helix beside it</source>
        <translation>笔画从材料内开始时的下刀方式：垂直下刀，或沿笔画斜坡下刀，否则在其旁边螺旋下刀</translation>
    </message>
    <message>
        <source>Share of the table value; feeds change with it, the chip load does not</source>
        <translation>占表中数值的比例；进给随之变化，每齿进给量不变</translation>
    </message>
    <message>
        <source>Value to keep constant: the force or the removal rate. With the limits, feeds are only reduced where the cut exceeds a limit of spindle or tool</source>
        <translation>要保持恒定的量：力或材料去除率。选择极限时，只在切削超出主轴或刀具极限处降低进给</translation>
    </message>
    <message>
        <source>Displacement of the points</source>
        <translation>点的位移</translation>
    </message>
    <message>
        <source>Height of the retraction inside the area</source>
        <translation>区域内抬刀的高度</translation>
    </message>
    <message>
        <source>one speed</source>
        <translation>单一转速</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>按材料</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>In several materials: one speed, the least that any of them allows, or the speed of each, which changes at their borders; feeds follow in both</source>
        <translation>有多种材料时：采用单一转速，即各材料允许转速中最低的，或采用各材料自己的转速，在交界处切换；两种情况下进给都随之变化</translation>
    </message>
    <message>
        <source>from the tables</source>
        <translation>按表</translation>
    </message>
    <message>
        <source>as the program states them</source>
        <translation>按程序给定</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>From the tables of tool and material, or as the program states them that the path is made of, within the limits of machine and tool; links are fed from the tables, but no faster than the moves that they join</source>
        <translation>按刀具和材料的表，或按生成此刀路的程序给定的值，均不超出机床和刀具的极限；连接的进给取自表，但不快于它所连接的移动</translation>
    </message>
    <message>
        <source>Feeds of these strokes are multiplied by this</source>
        <translation>这些笔画的进给乘以此系数</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>起点处</translation>
    </message>
    <message>
        <source>Added straight before the start of each stroke</source>
        <translation>在每个笔画起点之前沿直线添加</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>终点处</translation>
    </message>
    <message>
        <source>Added straight behind the end of each stroke</source>
        <translation>在每个笔画终点之后沿直线添加</translation>
    </message>
    <message>
        <source>Points in plan at which the path leaves a tab. Draw them in the view</source>
        <translation>刀路留出连接片的各点（俯视）。在视图中绘制</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Width of the tab that the cutter leaves</source>
        <translation>刀具留下的连接片宽度</translation>
    </message>
    <message>
        <source>Height of the tab above the lowest stroke there</source>
        <translation>连接片高出该处最低笔画的高度</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>不变</translation>
    </message>
    <message>
        <source>Of these strokes; feeds stay as they are. 0: unchanged</source>
        <translation>这些笔画的转速；进给保持不变。0：不变</translation>
    </message>
    <message>
        <source>Share of the speed</source>
        <translation>转速比例</translation>
    </message>
    <message>
        <source>Spindle speeds of these strokes are multiplied by this</source>
        <translation>这些笔画的主轴转速乘以此系数</translation>
    </message>
    <message>
        <source>Of these strokes, if the machine has it</source>
        <translation>这些笔画的冷却液，前提是机床具备</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>尖角</translation>
    </message>
    <message>
        <source>The point is inserted here. Select a point of the path first</source>
        <translation>在此处插入该点。请先选择刀路上的一点</translation>
    </message>
    <message>
        <source>Farther along</source>
        <translation>继续前行</translation>
    </message>
    <message>
        <source>Distance along the stroke from that position to the point</source>
        <translation>沿笔画从该位置到该点的距离</translation>
    </message>
    <message>
        <source>Displacement of the point from the stroke</source>
        <translation>该点相对笔画的位移</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>过渡长度</translation>
    </message>
    <message>
        <source>The stroke follows the point within this length on either side; 0: the point alone moves</source>
        <translation>笔画在两侧此长度内跟随该点；0：只移动该点</translation>
    </message>
    <message>
        <source>How the stroke leads to the point: in a smooth curve, or in straight lines to a corner</source>
        <translation>笔画如何通向该点：以平滑曲线，或以直线形成尖角</translation>
    </message>
    <message>
        <source>as the program states it</source>
        <translation>按程序所给</translation>
    </message>
    <message>
        <source>As advised for the material if the machine has it, as chosen here, or as the program that the path is made of switches it</source>
        <translation>机床具备时按材料建议，或按此处所选，或按生成该刀路的程序开关</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>a fixed direction</source>
        <translation>固定方向</translation>
    </message>
    <message>
        <source>the program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>turned in the links</source>
        <translation>在连接中转动</translation>
    </message>
    <message>
        <source>turned in the stroke</source>
        <translation>在笔画中转动</translation>
    </message>
    <message>
        <source>the contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>the tip</source>
        <translation>刀尖</translation>
    </message>
    <message>
        <source>Axis from</source>
        <translation>刀轴基准</translation>
    </message>
    <message>
        <source>Direction from which lead and tilt are counted: upright, or the normal of the part; or a fixed direction; or the axis that the program states of which the path is made</source>
        <translation>前倾角和侧倾角的基准方向：竖直或零件法线；或固定方向；或生成该刀路的程序给出的刀轴</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>前倾角</translation>
    </message>
    <message>
        <source>Angle in the direction of motion; above 0: the holder leans ahead</source>
        <translation>沿运动方向的角度；大于 0 时刀柄向前倾</translation>
    </message>
    <message>
        <source>Side tilt</source>
        <translation>侧倾角</translation>
    </message>
    <message>
        <source>Angle across the direction of motion; above 0: the holder leans to the left</source>
        <translation>垂直于运动方向的角度；大于 0 时刀柄向左倾</translation>
    </message>
    <message>
        <source>Inclination</source>
        <translation>倾斜角</translation>
    </message>
    <message>
        <source>Of a fixed direction: its angle from +Z</source>
        <translation>固定方向与 +Z 的夹角</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Of a fixed direction: where the holder leans in plan, anticlockwise from +X</source>
        <translation>固定方向在俯视图中的倾斜方位，从 +X 起逆时针计</translation>
    </message>
    <message>
        <source>Length over which the axis turns at the borders of the part of the path, and over which direction and normal are averaged</source>
        <translation>刀轴在该段刀路边界处转动的长度，也是方向和法线取平均的长度</translation>
    </message>
    <message>
        <source>At ends of strokes</source>
        <translation>笔画端部</translation>
    </message>
    <message>
        <source>Where the axis turns: in the rapids before and after the stroke, or inside it</source>
        <translation>刀轴转动的位置：在笔画前后的快速移动中，或在笔画内</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>The contact with the part while the tool tilts: the centre of a ball, or the plane that another tool touches; or the tip</source>
        <translation>刀具倾斜时与零件的接触：球头的球心，或其他刀具所接触的平面；或刀尖</translation>
    </message>
</context>
<context>
    <name>EmbeddingLabels</name>
    <message>
        <source>scanlines: %1</source>
        <translation>扫描线：%1</translation>
    </message>
    <message>
        <source>%1&#xa0;%2 to %3</source>
        <comment>X 0.000 to 10.000 mm</comment>
        <translation>%1&#xa0;%2 至 %3</translation>
    </message>
    <message>
        <source>The surface of “%1” is open (edges: %2), but no scanline meets a gap.</source>
        <translation>“%1”的表面不封闭（边：%2），但没有扫描线碰到缺口。</translation>
    </message>
    <message>
        <source>Faces of “%1” do not agree on which side is outside, so every second interval between them was filled (%2); make their normals agree in the CAD program.</source>
        <translation>“%1”的各面对哪一侧是外侧不一致，因此各面之间每隔一段填充一段（%2）；在 CAD 程序中统一其法线方向。</translation>
    </message>
    <message>
        <source>Shells of “%1” overlap, so everything inside any of them was filled (%2).</source>
        <translation>“%1”的壳体相互重叠，因此任一壳体内部都已填充（%2）。</translation>
    </message>
    <message>
        <source>“%1” is too small for the voxels, so nothing of it is protected; choose smaller voxels.</source>
        <translation>“%1”相对体素太小，因此完全没有受到保护；选择更小的体素。</translation>
    </message>
    <message>
        <source>“%1” overlaps “%2” in %3; there the later body counts.</source>
        <translation>“%1”与“%2”重叠（%3）；该处以后一个实体为准。</translation>
    </message>
    <message>
        <source>The surface of “%1” is open (edges: %2, rims: %3), so its inside is uncertain there (%4); close it in the CAD program.</source>
        <translation>“%1”的表面不封闭（边：%2，边缘环：%3），因此该处的内部不确定（%4）；在 CAD 程序中将其封闭。</translation>
    </message>
    <message>
        <source>A shell of “%1” is inside out and was filled as well (%2); a cavity has to lie within another shell.</source>
        <translation>“%1”的一个壳体内外翻转，也已填充（%2）；空腔必须位于另一个壳体之内。</translation>
    </message>
    <message>
        <source>Duplicate triangles of “%1” were counted once (%2).</source>
        <translation>“%1”的重复三角形只计一次（%2）。</translation>
    </message>
</context>
<context>
    <name>EntryLabels</name>
    <message>
        <source>plunges %1</source>
        <translation>垂直下刀 %1</translation>
    </message>
    <message>
        <source>ramps %1</source>
        <translation>斜坡下刀 %1</translation>
    </message>
    <message>
        <source>helices %1</source>
        <translation>螺旋下刀 %1</translation>
    </message>
    <message>
        <source>Plunge of %1 to X %2, Y %3, Z %4: no room for a ramp or helix</source>
        <translation>垂直下刀%1至 X %2，Y %3，Z %4：没有空间做斜坡或螺旋</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外%1个</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open a project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>Burin projects (*.burin)</source>
        <translation>Burin 项目 (*.burin)</translation>
    </message>
    <message>
        <source>Import a part</source>
        <translation>导入零件</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Export the program</source>
        <translation>导出程序</translation>
    </message>
    <message>
        <source>Import a fixture</source>
        <translation>导入夹具</translation>
    </message>
    <message>
        <source>Add a machine</source>
        <translation>添加机床</translation>
    </message>
    <message>
        <source>Machines (*.json)</source>
        <translation>机床 (*.json)</translation>
    </message>
    <message>
        <source>Programs (*.ngc *.nc *.tap);;All files (*)</source>
        <translation>程序 (*.ngc *.nc *.tap);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Parts (%1);;All files (*)</source>
        <translation>零件 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Export the workpiece</source>
        <translation>导出工件</translation>
    </message>
    <message>
        <source>Surfaces and voxels (*.stl *.ply *.3mf *.srle *.nrrd)</source>
        <translation>曲面和体素 (*.stl *.ply *.3mf *.srle *.nrrd)</translation>
    </message>
    <message>
        <source>Stock from a file</source>
        <translation>从文件读取毛坯</translation>
    </message>
    <message>
        <source>Volumes, voxel arrays and models (%1);;All files (*)</source>
        <translation>体积、体素数组和模型 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Materials of the values in %1</source>
        <translation>%1中各数值对应的材料</translation>
    </message>
    <message>
        <source>Tables (*.json);;All files (*)</source>
        <translation>表格 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>添加材料</translation>
    </message>
    <message>
        <source>Materials (*.json *.FCMat);;All files (*)</source>
        <translation>材料 (*.json *.FCMat);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Measured forces</source>
        <translation>实测力</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>表格 (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Models (%1);;All files (*)</source>
        <translation>模型 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Add a tool</source>
        <translation>添加刀具</translation>
    </message>
    <message>
        <source>Export tools</source>
        <translation>导出刀具</translation>
    </message>
    <message>
        <source>Export the setup sheet</source>
        <translation>导出装夹单</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Tools (*.json *.tools *.fctb *.fctl *.ctbl *.tbl);;All files (*)</source>
        <translation>刀具 (*.json *.tools *.fctb *.fctl *.ctbl *.tbl);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>图纸</translation>
    </message>
    <message>
        <source>Drawings (*.dxf *.svg *.DXF *.SVG);;All files (*)</source>
        <translation>图纸 (*.dxf *.svg *.DXF *.SVG);;所有文件 (*)</translation>
    </message>
    <message>
        <source>NC programs (%1)</source>
        <translation>NC 程序 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Path from a program</source>
        <translation>由程序生成刀路</translation>
    </message>
    <message>
        <source>Programs and cutter locations (%1);;All files (*)</source>
        <translation>程序和刀位文件 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Export the table of faces</source>
        <translation>导出面的表格</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Tools for other programs (*.fctl *.fctb *.tbl *.tools *.ctbl *.json)</source>
        <translation>供其他程序使用的刀具 (*.fctl *.fctb *.tbl *.tools *.ctbl *.json)</translation>
    </message>
    <message>
        <source>Record a session trace</source>
        <translation>记录会话轨迹</translation>
    </message>
    <message>
        <source>Traces (*.csv)</source>
        <translation>轨迹 (*.csv)</translation>
    </message>
</context>
<context>
    <name>FileUnits</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>%1 (stated)</source>
        <translation>%1（文件注明）</translation>
    </message>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1（假定）</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>retract above the material before this move</source>
        <translation>在此移动之前抬刀到材料上方</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with longer flutes</source>
        <translation>先铣掉周围的材料，或使用刃部更长的刀具</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with a longer stick-out</source>
        <translation>先铣掉周围的材料，或使用伸出长度更长的刀具</translation>
    </message>
    <message>
        <source>start the spindle before this move</source>
        <translation>在此移动之前启动主轴</translation>
    </message>
    <message>
        <source>place the part elsewhere on the table, or use a machine with more travel</source>
        <translation>把零件放到工作台的其他位置，或使用行程更大的机床</translation>
    </message>
    <message>
        <source>state X, Y and Z before this move</source>
        <translation>在此移动之前给定 X、Y 和 Z</translation>
    </message>
    <message>
        <source>move the fixture, or retract the path above it</source>
        <translation>移动夹具，或把刀路抬到夹具上方</translation>
    </message>
    <message>
        <source>mill it in more levels or with a smaller step-over, or use a stronger machine</source>
        <translation>增加分层数或减小行距来铣削，或使用更强的机床</translation>
    </message>
    <message>
        <source>mill it in more levels or with a smaller step-over, or use a thicker or shorter tool</source>
        <translation>增加分层数或减小行距来铣削，或使用更粗或更短的刀具</translation>
    </message>
    <message>
        <source>lower the feed</source>
        <translation>降低进给</translation>
    </message>
    <message>
        <source>mill it in more levels</source>
        <translation>增加分层数来铣削</translation>
    </message>
    <message>
        <source>use a smaller step-over</source>
        <translation>减小行距</translation>
    </message>
    <message>
        <source>begin beside the material, or use a centre-cutting tool</source>
        <translation>从材料旁边开始，或使用中心能切削的刀具</translation>
    </message>
    <message>
        <source>add the tool to the project with this number, or correct the number</source>
        <translation>把此编号的刀具添加到项目中，或更正编号</translation>
    </message>
    <message>
        <source>load the tool with M6 before this move</source>
        <translation>在此移动之前用 M6 换上刀具</translation>
    </message>
    <message>
        <source>correct the shift or the coordinates, or post the path again</source>
        <translation>更正偏移或坐标，或重新后处理刀路</translation>
    </message>
    <message>
        <source>choose smaller voxels</source>
        <translation>选择更小的体素</translation>
    </message>
    <message>
        <source>add G43 with the tool&apos;s H number after the tool change</source>
        <translation>在换刀之后添加 G43 和该刀具的 H 号</translation>
    </message>
    <message>
        <source>use the H number of the tool in the spindle</source>
        <translation>使用主轴上刀具的 H 号</translation>
    </message>
    <message>
        <source>use the work offset in which the project&apos;s zero is stored</source>
        <translation>使用存有项目零点的工件偏置</translation>
    </message>
    <message>
        <source>use M3: the tool is right-handed</source>
        <translation>使用 M3：该刀具是右旋刀具</translation>
    </message>
    <message>
        <source>use G64 with a small P, or G61</source>
        <translation>使用 P 值小的 G64，或使用 G61</translation>
    </message>
    <message>
        <source>retract or delete this part of the path, or mill it with a smaller tool</source>
        <translation>抬起或删除这段刀路，或用更小的刀具铣削</translation>
    </message>
    <message>
        <source>lower the feed to the machine&apos;s maximum</source>
        <translation>把进给降到机床的最大值</translation>
    </message>
    <message>
        <source>use a spindle speed within the machine&apos;s range</source>
        <translation>使用机床范围内的主轴转速</translation>
    </message>
    <message>
        <source>stop the spindle before this move, and hold it: the tool doesn&apos;t turn</source>
        <translation>在此移动之前停止并锁住主轴：该刀具不旋转</translation>
    </message>
    <message>
        <source>tilt the tool less, or use a machine whose rotary axes turn farther</source>
        <translation>减小刀具倾斜，或使用旋转轴行程更大的机床</translation>
    </message>
</context>
<context>
    <name>FindingName</name>
    <message>
        <source>gouge</source>
        <translation>过切</translation>
    </message>
    <message>
        <source>rapid_in_stock</source>
        <translation>材料中快速移动</translation>
    </message>
    <message>
        <source>shank_collision</source>
        <translation>刀杆碰撞</translation>
    </message>
    <message>
        <source>holder_collision</source>
        <translation>刀柄碰撞</translation>
    </message>
    <message>
        <source>spindle_off</source>
        <translation>主轴未转</translation>
    </message>
    <message>
        <source>travel_limit</source>
        <translation>超出行程</translation>
    </message>
    <message>
        <source>feed_limit</source>
        <translation>超出进给极限</translation>
    </message>
    <message>
        <source>spindle_limit</source>
        <translation>超出转速极限</translation>
    </message>
    <message>
        <source>unknown_start</source>
        <translation>起点未知</translation>
    </message>
    <message>
        <source>obstacle_collision</source>
        <translation>与障碍物碰撞</translation>
    </message>
    <message>
        <source>spindle_power</source>
        <translation>主轴功率</translation>
    </message>
    <message>
        <source>spindle_torque</source>
        <translation>主轴扭矩</translation>
    </message>
    <message>
        <source>tool_breakage</source>
        <translation>刀具折断</translation>
    </message>
    <message>
        <source>tool_bending</source>
        <translation>刀具弯曲</translation>
    </message>
    <message>
        <source>chip_load</source>
        <translation>每齿进给量</translation>
    </message>
    <message>
        <source>depth_of_cut</source>
        <translation>切深</translation>
    </message>
    <message>
        <source>width_of_cut</source>
        <translation>切宽</translation>
    </message>
    <message>
        <source>plunge_without_centre</source>
        <translation>无中心刃垂直下刀</translation>
    </message>
    <message>
        <source>tool_unknown</source>
        <translation>刀具未知</translation>
    </message>
    <message>
        <source>tool_not_loaded</source>
        <translation>刀具未换上</translation>
    </message>
    <message>
        <source>length_offset_missing</source>
        <translation>缺少长度补偿</translation>
    </message>
    <message>
        <source>length_offset_of_another_tool</source>
        <translation>用了其他刀具的长度补偿</translation>
    </message>
    <message>
        <source>other_work_offset</source>
        <translation>工件偏置不符</translation>
    </message>
    <message>
        <source>spindle_reversed</source>
        <translation>主轴反转</translation>
    </message>
    <message>
        <source>corner_gouge</source>
        <translation>拐角过切</translation>
    </message>
    <message>
        <source>corner_excess</source>
        <translation>拐角残料</translation>
    </message>
    <message>
        <source>allowance_differs</source>
        <translation>余量不符</translation>
    </message>
    <message>
        <source>part_not_protected</source>
        <translation>零件未受保护</translation>
    </message>
    <message>
        <source>shank_near_stock</source>
        <translation>刀杆靠近毛坯</translation>
    </message>
    <message>
        <source>shank_near_part</source>
        <translation>刀杆靠近零件</translation>
    </message>
    <message>
        <source>shank_near_obstacle</source>
        <translation>刀杆靠近障碍物</translation>
    </message>
    <message>
        <source>holder_near_stock</source>
        <translation>刀柄靠近毛坯</translation>
    </message>
    <message>
        <source>holder_near_part</source>
        <translation>刀柄靠近零件</translation>
    </message>
    <message>
        <source>holder_near_obstacle</source>
        <translation>刀柄靠近障碍物</translation>
    </message>
    <message>
        <source>spindle_on</source>
        <translation>主轴旋转</translation>
    </message>
</context>
<context>
    <name>FirstJob</name>
    <message>
        <source>Open the sample part</source>
        <translation>打开示例零件</translation>
    </message>
    <message>
        <source>Press “Try the sample part”. It is a computer mouse, 110 mm long. A part of your own does as well.</source>
        <translation>按“试用示例零件”。它是一个长 110 mm 的电脑鼠标。也可以用自己的零件。</translation>
    </message>
    <message>
        <source>Choose the stock</source>
        <translation>设定毛坯</translation>
    </message>
    <message>
        <source>The margins state how much stock is around the part. Enter %1 as the voxel size: large voxels are coarse, but quick.</source>
        <translation>余量表示零件四周有多少毛坯。把体素尺寸设为 %1：体素大则粗糙，但速度快。</translation>
    </message>
    <message>
        <source>Embed the part</source>
        <translation>嵌入零件</translation>
    </message>
    <message>
        <source>Press “Embed the part”. Burin puts the part in its stock; this makes the workpiece.</source>
        <translation>按“嵌入零件”。Burin 把零件放入毛坯，由此得到工件。</translation>
    </message>
    <message>
        <source>Choose a tool</source>
        <translation>选择刀具</translation>
    </message>
    <message>
        <source>Click “%1” in the list. Any other tool will do.</source>
        <translation>在列表中点击“%1”。其他刀具也可以。</translation>
    </message>
    <message>
        <source>Start milling</source>
        <translation>开始铣削</translation>
    </message>
    <message>
        <source>Press “Mill”. From then on the left mouse button cuts in the view, and everything that is cut is recorded.</source>
        <translation>按“铣削”。此后在视图中按鼠标左键即可切削，所有切削都会录制下来。</translation>
    </message>
    <message>
        <source>Mill a stroke</source>
        <translation>铣一条笔画</translation>
    </message>
    <message>
        <source>Hold the left mouse button and drag over the stock. The tool cuts where you drag, and stops at the part.</source>
        <translation>按住鼠标左键在毛坯上拖动。拖到哪里，刀具就切到哪里，碰到零件即停。</translation>
    </message>
    <message>
        <source>Stop milling</source>
        <translation>停止铣削</translation>
    </message>
    <message>
        <source>Press the button again. What you milled is listed as a take.</source>
        <translation>再按一次该按钮。铣过的内容会作为录制列出。</translation>
    </message>
    <message>
        <source>Make a path</source>
        <translation>新建刀路</translation>
    </message>
    <message>
        <source>Press “New path from the takes”. The take becomes a tool path with the standard edits.</source>
        <translation>按“由录制新建刀路”。录制会变成带有标准编辑步骤的刀路。</translation>
    </message>
    <message>
        <source>Add an edit</source>
        <translation>添加编辑步骤</translation>
    </message>
    <message>
        <source>Press “Add an edit” and choose “Smooth” under “Smoother, fewer moves”. Any other edit does as well.</source>
        <translation>按“添加编辑步骤”，在“平滑并减少移动”中选择“平滑”。其他编辑步骤也可以。</translation>
    </message>
    <message>
        <source>Post and check</source>
        <translation>后处理并检查</translation>
    </message>
    <message>
        <source>Press “Post and check”. Burin makes the NC program, reads it back and mills it again on the stock.</source>
        <translation>按“后处理并检查”。Burin 生成 NC 程序，再读回，并在毛坯上重新铣削一遍。</translation>
    </message>
    <message>
        <source>Export the program (optional)</source>
        <translation>导出程序（可选）</translation>
    </message>
    <message>
        <source>Press “Export…” and choose a file, or skip this step.</source>
        <translation>按“导出…”并选择文件，或跳过此步。</translation>
    </message>
    <message>
        <source>Return to the project.</source>
        <translation>返回项目。</translation>
    </message>
    <message>
        <source>Click “%1” at the top of the window.</source>
        <translation>点击窗口上方的“%1”。</translation>
    </message>
</context>
<context>
    <name>Fixture</name>
    <message>
        <source>estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>开口</translation>
    </message>
    <message>
        <source>Distance between the jaws: the width of the stock</source>
        <translation>钳口之间的距离：毛坯的宽度</translation>
    </message>
    <message>
        <source>Depth of grip</source>
        <translation>夹持深度</translation>
    </message>
    <message>
        <source>Height of the stock that is between the jaws</source>
        <translation>毛坯位于钳口之间的高度</translation>
    </message>
    <message>
        <source>Jaw width</source>
        <translation>钳口宽度</translation>
    </message>
    <message>
        <source>Length of the jaws along the stock</source>
        <translation>钳口沿毛坯的长度</translation>
    </message>
    <message>
        <source>Jaw height</source>
        <translation>钳口高度</translation>
    </message>
    <message>
        <source>From the bed of the vise to the top of the jaws</source>
        <translation>从虎钳导轨面到钳口顶面</translation>
    </message>
    <message>
        <source>Jaw depth</source>
        <translation>钳口厚度</translation>
    </message>
    <message>
        <source>Thickness of each jaw in the direction of clamping</source>
        <translation>每个钳口沿夹紧方向的厚度</translation>
    </message>
    <message>
        <source>Body width</source>
        <translation>本体宽度</translation>
    </message>
    <message>
        <source>Width of the body, in the direction of the jaws</source>
        <translation>本体沿钳口方向的宽度</translation>
    </message>
    <message>
        <source>Body height</source>
        <translation>本体高度</translation>
    </message>
    <message>
        <source>From the table to the bed of the vise</source>
        <translation>从工作台到虎钳导轨面</translation>
    </message>
    <message>
        <source>Clamping height</source>
        <translation>夹紧高度</translation>
    </message>
    <message>
        <source>From the table to the lower side of the bar</source>
        <translation>从工作台到压板下表面</translation>
    </message>
    <message>
        <source>Bar length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Length of the bar</source>
        <translation>压板的长度</translation>
    </message>
    <message>
        <source>Bar width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Width of the bar</source>
        <translation>压板的宽度</translation>
    </message>
    <message>
        <source>Bar thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Height of the bar</source>
        <translation>压板的高度</translation>
    </message>
    <message>
        <source>Contact length</source>
        <translation>接触长度</translation>
    </message>
    <message>
        <source>Length of the bar&apos;s nose that presses on the stock</source>
        <translation>压板前端压在毛坯上的长度</translation>
    </message>
    <message>
        <source>Stud distance</source>
        <translation>螺柱距离</translation>
    </message>
    <message>
        <source>Stud diameter</source>
        <translation>螺柱直径</translation>
    </message>
    <message>
        <source>Diameter of the stud&apos;s thread</source>
        <translation>螺柱螺纹的直径</translation>
    </message>
    <message>
        <source>Slot width</source>
        <translation>槽宽</translation>
    </message>
    <message>
        <source>Width of the hole in the bar around the stud</source>
        <translation>压板上螺柱孔的宽度</translation>
    </message>
    <message>
        <source>Washer diameter</source>
        <translation>垫圈直径</translation>
    </message>
    <message>
        <source>Diameter of the washer below the nut</source>
        <translation>螺母下方垫圈的直径</translation>
    </message>
    <message>
        <source>Washer thickness</source>
        <translation>垫圈厚度</translation>
    </message>
    <message>
        <source>Thickness of the washer</source>
        <translation>垫圈的厚度</translation>
    </message>
    <message>
        <source>Nut width</source>
        <translation>螺母对边宽度</translation>
    </message>
    <message>
        <source>Nut height</source>
        <translation>螺母高度</translation>
    </message>
    <message>
        <source>Height of the nut</source>
        <translation>螺母的高度</translation>
    </message>
    <message>
        <source>Stud end</source>
        <translation>螺柱露出长度</translation>
    </message>
    <message>
        <source>How far the stud reaches above the nut</source>
        <translation>螺柱在螺母上方伸出的长度</translation>
    </message>
    <message>
        <source>Step block length</source>
        <translation>阶梯垫块长度</translation>
    </message>
    <message>
        <source>Length of the step block below the end of the bar; it has three steps</source>
        <translation>压板末端下方阶梯垫块的长度；共三级台阶</translation>
    </message>
    <message>
        <source>Nose height</source>
        <translation>压头高度</translation>
    </message>
    <message>
        <source>From the table to the top of the nose</source>
        <translation>从工作台到压头顶面</translation>
    </message>
    <message>
        <source>Nose thickness</source>
        <translation>压头厚度</translation>
    </message>
    <message>
        <source>Height of the nose that presses on the side of the stock</source>
        <translation>压在毛坯侧面上的压头的高度</translation>
    </message>
    <message>
        <source>Nose length</source>
        <translation>压头长度</translation>
    </message>
    <message>
        <source>Nose width</source>
        <translation>压头宽度</translation>
    </message>
    <message>
        <source>Width of the nose along the side of the stock</source>
        <translation>压头沿毛坯侧面的宽度</translation>
    </message>
    <message>
        <source>Body length</source>
        <translation>本体长度</translation>
    </message>
    <message>
        <source>Length of the body, away from the stock</source>
        <translation>本体的长度，背离毛坯方向</translation>
    </message>
    <message>
        <source>Width of the body along the side of the stock</source>
        <translation>本体沿毛坯侧面的宽度</translation>
    </message>
    <message>
        <source>From the table to the top of the body</source>
        <translation>从工作台到本体顶面</translation>
    </message>
    <message>
        <source>Thread diameter</source>
        <translation>螺纹直径</translation>
    </message>
    <message>
        <source>Diameter of the screw&apos;s thread</source>
        <translation>螺钉螺纹的直径</translation>
    </message>
    <message>
        <source>Head height</source>
        <translation>头部高度</translation>
    </message>
    <message>
        <source>Height of the head</source>
        <translation>头部的高度</translation>
    </message>
    <message>
        <source>Screw length</source>
        <translation>螺钉长度</translation>
    </message>
    <message>
        <source>How far the screw reaches below the washer</source>
        <translation>螺钉在垫圈下方伸出的长度</translation>
    </message>
    <message>
        <source>Diameter of the washer below the head</source>
        <translation>头部下方垫圈的直径</translation>
    </message>
    <message>
        <source>Head width</source>
        <translation>头部对边宽度</translation>
    </message>
    <message>
        <source>Head diameter</source>
        <translation>头部直径</translation>
    </message>
    <message>
        <source>Diameter of the head with its socket</source>
        <translation>内六角头部的直径</translation>
    </message>
    <message>
        <source>Length of each of the two bars</source>
        <translation>两条垫铁各自的长度</translation>
    </message>
    <message>
        <source>Width of each bar, across its length</source>
        <translation>每条垫铁的宽度，垂直于其长度</translation>
    </message>
    <message>
        <source>Bar height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>From the table to the stock</source>
        <translation>从工作台到毛坯</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Between the middles of both bars</source>
        <translation>两条垫铁中线之间</translation>
    </message>
    <message>
        <source>Plate length</source>
        <translation>底板长度</translation>
    </message>
    <message>
        <source>Along its X axis</source>
        <translation>沿其 X 轴</translation>
    </message>
    <message>
        <source>Plate width</source>
        <translation>底板宽度</translation>
    </message>
    <message>
        <source>Along its Y axis</source>
        <translation>沿其 Y 轴</translation>
    </message>
    <message>
        <source>Plate thickness</source>
        <translation>底板厚度</translation>
    </message>
    <message>
        <source>From its lower to its upper face</source>
        <translation>从其下表面到上表面</translation>
    </message>
    <message>
        <source>Vise</source>
        <translation>虎钳</translation>
    </message>
    <message>
        <source>Closes on the clicked side of the stock and the opposite one</source>
        <translation>夹住毛坯上被单击的侧面及其对面</translation>
    </message>
    <message>
        <source>Step clamp</source>
        <translation>阶梯压板</translation>
    </message>
    <message>
        <source>A bar with stud and step block that presses on the top of the stock</source>
        <translation>带螺柱和阶梯垫块、压在毛坯顶面上的压板</translation>
    </message>
    <message>
        <source>Toe clamp</source>
        <translation>侧压板</translation>
    </message>
    <message>
        <source>Presses on a side of the stock and leaves its top free</source>
        <translation>压在毛坯的侧面上，顶面保持空出</translation>
    </message>
    <message>
        <source>Hexagon screw</source>
        <translation>六角螺钉</translation>
    </message>
    <message>
        <source>A screw through the stock with hexagon head and washer</source>
        <translation>穿过毛坯的螺钉，带六角头和垫圈</translation>
    </message>
    <message>
        <source>Socket screw</source>
        <translation>内六角螺钉</translation>
    </message>
    <message>
        <source>A screw through the stock with socket head and washer</source>
        <translation>穿过毛坯的螺钉，带内六角圆柱头和垫圈</translation>
    </message>
    <message>
        <source>Two bars below the stock</source>
        <translation>毛坯下方的两条垫铁</translation>
    </message>
    <message>
        <source>A plate below the stock; its top is the table for clamps that are placed later</source>
        <translation>毛坯下方的底板；其顶面是之后放置的压板所用的工作台</translation>
    </message>
    <message>
        <source>Rear overhang</source>
        <translation>后方伸出长度</translation>
    </message>
    <message>
        <source>How far the body and the screw of the vise extend behind the movable jaw</source>
        <translation>虎钳本体和丝杠在活动钳口后方伸出的长度</translation>
    </message>
    <message>
        <source>From the clamping point to the axis of the stud</source>
        <translation>从压紧点到螺柱轴线</translation>
    </message>
    <message>
        <source>Width across flats; the tool keeps clear of the width across corners, in any position of the nut</source>
        <translation>对边宽度；无论螺母朝向如何，刀具均按对角宽度避让</translation>
    </message>
    <message>
        <source>How far the nose extends from the body</source>
        <translation>压头从本体伸出的长度</translation>
    </message>
    <message>
        <source>Width across flats; the tool keeps clear of the width across corners, in any position of the head</source>
        <translation>对边宽度；无论头部朝向如何，刀具均按对角宽度避让</translation>
    </message>
    <message>
        <source>Parallels (pair)</source>
        <translation>平行垫铁（一对）</translation>
    </message>
    <message>
        <source>Base plate</source>
        <translation>底板</translation>
    </message>
</context>
<context>
    <name>FixtureLabels</name>
    <message>
        <source>“%1” is %2 deep in the stock; change its position or size.</source>
        <translation>“%1”进入毛坯 %2；请更改其位置或尺寸。</translation>
    </message>
    <message>
        <source>There is no stock where “%1” clamps; change its position or size.</source>
        <translation>“%1”的夹紧处没有毛坯；请更改其位置或尺寸。</translation>
    </message>
    <message>
        <source>“%1” doesn&apos;t touch the stock: a gap of %2 remains.</source>
        <translation>“%1”没有接触毛坯：还有 %2 的间隙。</translation>
    </message>
</context>
<context>
    <name>GuideLabels</name>
    <message>
        <source>%1 apart</source>
        <translation>间隔%1</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>分层</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Edge of the part</source>
        <translation>零件的边</translation>
    </message>
    <message>
        <source>Distance from the part</source>
        <translation>与零件的距离</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Lead and tilt</source>
        <translation>前倾和侧倾</translation>
    </message>
</context>
<context>
    <name>HandTimeLabels</name>
    <message>
        <source>take %1</source>
        <translation>录制%1</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>采样点%1</translation>
    </message>
    <message>
        <source>≈ %1 s</source>
        <translation>≈ %1 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1，从%2起</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1，%2至%3</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>走刀%1</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>移动%1</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Print one JSON object on standard output</source>
        <translation>在标准输出上输出一个 JSON 对象</translation>
    </message>
    <message>
        <source>Usage</source>
        <translation>用法</translation>
    </message>
    <message>
        <source>OPTIONS</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>SUBCOMMAND</source>
        <translation>子命令</translation>
    </message>
    <message>
        <source>SUBCOMMANDS</source>
        <translation>子命令</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Positionals</source>
        <translation>位置参数</translation>
    </message>
    <message>
        <source>Subcommands</source>
        <translation>子命令</translation>
    </message>
    <message>
        <source>REQUIRED</source>
        <translation>必需</translation>
    </message>
    <message>
        <source>Needs</source>
        <translation>需要</translation>
    </message>
    <message>
        <source>Excludes</source>
        <translation>不可同时使用</translation>
    </message>
    <message>
        <source>TEXT</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>INT</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>UINT</source>
        <translation>非负整数</translation>
    </message>
    <message>
        <source>FLOAT</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>%1 in [%2 - %3]</source>
        <translation>%1，范围 [%2 - %3]</translation>
    </message>
    <message>
        <source>Burin: milling tool paths authored by hand</source>
        <translation>Burin：手工制作铣削刀路</translation>
    </message>
    <message>
        <source>Print this help message and exit</source>
        <translation>显示此帮助信息并退出</translation>
    </message>
    <message>
        <source>Display program version information and exit</source>
        <translation>显示程序版本信息并退出</translation>
    </message>
    <message>
        <source>Help for all commands</source>
        <translation>所有命令的帮助</translation>
    </message>
    <message>
        <source>Run Burin&apos;s benchmarks</source>
        <translation>运行 Burin 的基准测试</translation>
    </message>
    <message>
        <source>Benchmark to run (default: list the benchmarks)</source>
        <translation>要运行的基准测试（默认：列出基准测试）</translation>
    </message>
    <message>
        <source>Only figures whose names begin with this</source>
        <translation>只限名称以此开头的数值</translation>
    </message>
    <message>
        <source>Number of rounds in which everything is measured</source>
        <translation>全部测量所进行的轮数</translation>
    </message>
    <message>
        <source>FORCES is CSV with one row per cut, or per sample of a cut (column cut), and the columns
  %1
and, where they are needed,
  %2.
Forces are means over whole revolutions; the axis points from tip to holder; any frame. Columns named note… are ignored.</source>
        <translation>FORCES 是 CSV 文件，每次切削一行，或一次切削的每个采样点一行（列 cut），包含以下列：
  %1
必要时还有
  %2。
力是整转内的平均值；轴线从刀尖指向刀柄；坐标系任意。名称以 note… 开头的列会被忽略。</translation>
    </message>
    <message>
        <source>Fit K, Kr and edge forces of materials to measured forces and add them to your own library</source>
        <translation>用实测力拟合材料的 K、Kr 和刃口力，并添加到自己的库中</translation>
    </message>
    <message>
        <source>Force records (.csv)</source>
        <translation>力的记录 (.csv)</translation>
    </message>
    <message>
        <source>Only this one of the materials in the file</source>
        <translation>只用文件中的这一种材料</translation>
    </message>
    <message>
        <source>edge: K and the force of the edge, Kte and Kre; constant: K alone; kienzle: K falling with the chip&apos;s thickness</source>
        <translation>edge：K 和刃口力 Kte、Kre；constant：只有 K；kienzle：K 随切屑厚度增大而减小</translation>
    </message>
    <message>
        <source>teeth: resolved for rotating teeth, for forces of a dynamometer; paper: tangential against the feed, radial along the axis, for the force that the hand feels</source>
        <translation>teeth：按旋转的刀齿分解，用于测力仪测得的力；paper：切向与进给方向相反，径向沿轴线，用于手感受到的力</translation>
    </message>
    <message>
        <source>The measured forces act on the workpiece, not on the tool</source>
        <translation>实测力作用在工件上，而不是刀具上</translation>
    </message>
    <message>
        <source>Material from which a new one takes its other values</source>
        <translation>新材料的其他数值取自此材料</translation>
    </message>
    <message>
        <source>Replace a material of that name</source>
        <translation>替换同名材料</translation>
    </message>
    <message>
        <source>Fit and report, but write nothing</source>
        <translation>拟合并报告，但不写入任何内容</translation>
    </message>
    <message>
        <source>Do the whole job on the sample part with a virtual operator</source>
        <translation>由虚拟操作员在示例零件上完成整个加工任务</translation>
    </message>
    <message>
        <source>Mill the block of the paper&apos;s figure 13 (b) instead</source>
        <translation>改为铣削论文图 13 (b) 中的方块</translation>
    </message>
    <message>
        <source>Tool (ball-6; ball-1 with --block)</source>
        <translation>刀具（ball-6；使用 --block 时为 ball-1）</translation>
    </message>
    <message>
        <source>Edge of a voxel, mm (0.5; 0.1 with --block)</source>
        <translation>体素边长，mm（0.5；使用 --block 时为 0.1）</translation>
    </message>
    <message>
        <source>Time limit of the operator, s; 0: none</source>
        <translation>操作员的时间限制，s；0：无</translation>
    </message>
    <message>
        <source>Stock around the part, mm</source>
        <translation>零件周围的毛坯余量，mm</translation>
    </message>
    <message>
        <source>Material of the stock</source>
        <translation>毛坯的材料</translation>
    </message>
    <message>
        <source>Seed of the operator&apos;s random tremor</source>
        <translation>操作员随机抖动的随机种子</translation>
    </message>
    <message>
        <source>Folder for project, program, picture and report</source>
        <translation>存放项目、程序、图片和报告的文件夹</translation>
    </message>
    <message>
        <source>List the styluses that are plugged in, and their limits</source>
        <translation>列出已连接的触笔及其极限值</translation>
    </message>
    <message>
        <source>Embed a CAD model in stock and make a project</source>
        <translation>把 CAD 模型嵌入毛坯并创建项目</translation>
    </message>
    <message>
        <source>Project file to write (.burin)</source>
        <translation>要写入的项目文件 (.burin)</translation>
    </message>
    <message>
        <source>Replace a project that holds recordings</source>
        <translation>替换含有录制的项目</translation>
    </message>
    <message>
        <source>Make the project even if bodies are too small for the voxels to be protected</source>
        <translation>即使有实体相对体素太小而无法受到保护，也创建项目</translation>
    </message>
    <message>
        <source>Edge of a voxel, mm</source>
        <translation>体素边长，mm</translation>
    </message>
    <message>
        <source>Stock around the part on every side, mm</source>
        <translation>零件每一侧的毛坯余量，mm</translation>
    </message>
    <message>
        <source>Read a CAD model and report its contents</source>
        <translation>读取 CAD 模型并报告其内容</translation>
    </message>
    <message>
        <source>Chord of the mesh, mm</source>
        <translation>网格的弦高误差，mm</translation>
    </message>
    <message>
        <source>Limit of the import&apos;s processor time, s; its elapsed time may be ten times as long</source>
        <translation>导入的处理器时间限制，s；实际用时可达其十倍</translation>
    </message>
    <message>
        <source>Memory limit of the import, MB</source>
        <translation>导入的内存限制，MB</translation>
    </message>
    <message>
        <source>Report the contents of a project</source>
        <translation>报告项目的内容</translation>
    </message>
    <message>
        <source>Project file (.burin)</source>
        <translation>项目文件 (.burin)</translation>
    </message>
    <message>
        <source>List and show machines; copy, add and delete your own. The machines that Burin is shipped with have typical values of their class: copy one and enter those of your machine</source>
        <translation>列出和显示机床；复制、添加和删除自己的机床。Burin 自带的机床采用同类机床的典型值：复制一台，再输入自己机床的数值</translation>
    </message>
    <message>
        <source>List all machines with their names; typical: shipped with Burin</source>
        <translation>列出所有机床及其名称；典型：Burin 自带</translation>
    </message>
    <message>
        <source>Replace your machine of this ID</source>
        <translation>替换自己的机床中此 ID 的机床</translation>
    </message>
    <message>
        <source>Print the file of a machine (JSON), in the form that add reads</source>
        <translation>输出机床的文件 (JSON)，格式与 add 读取的相同</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Add a machine to your own; every value is checked</source>
        <translation>添加一台自己的机床；每个数值都会检查</translation>
    </message>
    <message>
        <source>Machine file (JSON)</source>
        <translation>机床文件 (JSON)</translation>
    </message>
    <message>
        <source>Copy a machine to one of your own</source>
        <translation>把机床复制为自己的机床</translation>
    </message>
    <message>
        <source>Machine to copy</source>
        <translation>要复制的机床</translation>
    </message>
    <message>
        <source>ID of the copy: letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>副本的 ID：字母、数字、“-”、“_”和“.”</translation>
    </message>
    <message>
        <source>Name of the copy (default: its ID)</source>
        <translation>副本的名称（默认：其 ID）</translation>
    </message>
    <message>
        <source>Delete one of your own machines</source>
        <translation>删除一台自己的机床</translation>
    </message>
    <message>
        <source>Mill a project&apos;s workpiece with a stylus and record it</source>
        <translation>用触笔铣削项目的工件并进行录制</translation>
    </message>
    <message>
        <source>Seed of the operator&apos;s random tremor and motion</source>
        <translation>操作员随机抖动和动作的随机种子</translation>
    </message>
    <message>
        <source>Firmness of the operator&apos;s grip on the stylus</source>
        <translation>操作员握触笔的力度</translation>
    </message>
    <message>
        <source>Kind of strokes that the operator makes</source>
        <translation>操作员所做笔画的种类</translation>
    </message>
    <message>
        <source>Stylus: operator, trace:FILE or device:NAME</source>
        <translation>触笔：operator、trace:文件 或 device:名称</translation>
    </message>
    <message>
        <source>One of a device&apos;s modes, as &quot;burin devices&quot; lists them</source>
        <translation>设备的一种模式，由“burin devices”列出</translation>
    </message>
    <message>
        <source>Rate of the haptic loop, Hz; a device with its own clock sets its own rate</source>
        <translation>力反馈循环的频率，Hz；自带时钟的设备使用自己的频率</translation>
    </message>
    <message>
        <source>Forces only while this button of the device is held, counted from 1; 0: always</source>
        <translation>只在按住设备的此按钮时才有力，从 1 开始编号；0：始终有力</translation>
    </message>
    <message>
        <source>Also write the motion of the trace or device to this file, which --stylus trace:FILE replays</source>
        <translation>同时把轨迹或设备的运动写入此文件，可用 --stylus trace:文件 回放</translation>
    </message>
    <message>
        <source>Mill even if bodies are too small for the voxels to be protected, and accept that the operator reaches nothing</source>
        <translation>即使有实体相对体素太小而无法受到保护，也进行铣削，并接受操作员什么也够不到的情况</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Machine, for its spindle speed and travel (default: the project&apos;s)</source>
        <translation>机床，用于确定主轴转速和行程（默认：项目的机床）</translation>
    </message>
    <message>
        <source>Run in real time</source>
        <translation>实时运行</translation>
    </message>
    <message>
        <source>Run as fast as the computer can (the default)</source>
        <translation>以计算机的最快速度运行（默认）</translation>
    </message>
    <message>
        <source>Length of the session, s; 0: as long as the job takes</source>
        <translation>会话时长，s；0：任务需要多久就多久</translation>
    </message>
    <message>
        <source>Stock to leave on the part, mm; the operator roughs with it (0.5)</source>
        <translation>零件上要留的余量，mm；操作员按此余量粗加工 (0.5)</translation>
    </message>
    <message>
        <source>Depth to which the operator presses into the part when finishing, mm</source>
        <translation>精加工时操作员压入零件的深度，mm</translation>
    </message>
    <message>
        <source>Distance between finishing passes, mm; 0: chosen for the tool</source>
        <translation>精加工走刀之间的距离，mm；0：按刀具选择</translation>
    </message>
    <message>
        <source>List, make, edit and export paths</source>
        <translation>列出、创建、编辑和导出刀路</translation>
    </message>
    <message>
        <source>Number of the path</source>
        <translation>刀路编号</translation>
    </message>
    <message>
        <source>List the paths and their edits</source>
        <translation>列出刀路及其编辑步骤</translation>
    </message>
    <message>
        <source>Takes in order, all of one tool (default: all takes of the last tool that milled)</source>
        <translation>按顺序排列的录制，全部使用同一刀具（默认：最后铣削的刀具的所有录制）</translation>
    </message>
    <message>
        <source>Evaluate a path and report what each edit did</source>
        <translation>计算刀路并报告每个编辑步骤的作用</translation>
    </message>
    <message>
        <source>Write the points as CSV</source>
        <translation>把点写为 CSV</translation>
    </message>
    <message>
        <source>The same as --output</source>
        <translation>与 --output 相同</translation>
    </message>
    <message>
        <source>Machine (default: the project&apos;s)</source>
        <translation>机床（默认：项目的机床）</translation>
    </message>
    <message>
        <source>The edit as JSON, as &quot;burin path P list --json&quot; shows them</source>
        <translation>JSON 格式的编辑步骤，与“burin path P list --json”显示的相同</translation>
    </message>
    <message>
        <source>Position in the list of edits, from 0</source>
        <translation>在编辑步骤列表中的位置，从 0 开始</translation>
    </message>
    <message>
        <source>Delete an edit from a path</source>
        <translation>从刀路中删除一个编辑步骤</translation>
    </message>
    <message>
        <source>Position of the edit in the list, from 0</source>
        <translation>编辑步骤在列表中的位置，从 0 开始</translation>
    </message>
    <message>
        <source>Bring an edit of an earlier version up to date</source>
        <translation>更新早期版本的编辑步骤</translation>
    </message>
    <message>
        <source>Write the stylus motion of a take as a trace that &quot;burin mill&quot; replays</source>
        <translation>把录制中的触笔运动写为轨迹，可用“burin mill”回放</translation>
    </message>
    <message>
        <source>Write a take as CSV</source>
        <translation>把录制写为 CSV</translation>
    </message>
    <message>
        <source>Number of the take</source>
        <translation>录制编号</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>要写入的文件</translation>
    </message>
    <message>
        <source>Draw a project&apos;s workpiece as its takes left it</source>
        <translation>绘制项目的工件在各次录制之后的样子</translation>
    </message>
    <message>
        <source>Picture to write (.png)</source>
        <translation>要写入的图片 (.png)</translation>
    </message>
    <message>
        <source>Paths to draw, the first in the colours of its moves</source>
        <translation>要绘制的刀路，第一条按其移动的颜色绘制</translation>
    </message>
    <message>
        <source>Write a path as a program, once the program passes its check</source>
        <translation>程序通过检查后，把刀路写为程序</translation>
    </message>
    <message>
        <source>Program to write</source>
        <translation>要写入的程序</translation>
    </message>
    <message>
        <source>Units of the program: mm (G21) or inch (G20) (default: the project&apos;s)</source>
        <translation>程序的单位：mm (G21) 或 inch (G20)（默认：项目的单位）</translation>
    </message>
    <message>
        <source>Dialect of the control (default: the project&apos;s, or the machine&apos;s)</source>
        <translation>控制系统的方言（默认：项目的或机床的方言）</translation>
    </message>
    <message>
        <source>Paths of the program, which may have different tools (default: the first path of each tool that milled)</source>
        <translation>程序的刀路，可使用不同刀具（默认：每把铣削过的刀具的第一条刀路）</translation>
    </message>
    <message>
        <source>Deepest gouge that passes, mm</source>
        <translation>允许通过的最深过切，mm</translation>
    </message>
    <message>
        <source>Restart after a broken tool: line of the program that was posted last; the lines before it are done. Writes the rest, which leads back into the cut and is checked on the stock that is left</source>
        <translation>刀具折断后重新开始：上次后处理的程序的行号；此行之前的各行已完成。写入其余部分，它会重新切入，并在剩余的毛坯上检查</translation>
    </message>
    <message>
        <source>With --from: the interrupted program (default: the one that the project posted last)</source>
        <translation>与 --from 一起使用：被中断的程序（默认：项目上次后处理的程序）</translation>
    </message>
    <message>
        <source>Write the program even if its check refuses it; states this reason in its header</source>
        <translation>即使检查未通过也写入程序；在程序头中写明此理由</translation>
    </message>
    <message>
        <source>Name of a fixture or keep-out volume to delete; may be repeated</source>
        <translation>要删除的夹具或禁入区的名称；可重复使用</translation>
    </message>
    <message>
        <source>Name of a fixture or keep-out volume to switch off; it stays in the project; may be repeated</source>
        <translation>要停用的夹具或禁入区的名称；仍保留在项目中；可重复使用</translation>
    </message>
    <message>
        <source>Name of a fixture or keep-out volume to switch on again; may be repeated</source>
        <translation>要重新启用的夹具或禁入区的名称；可重复使用</translation>
    </message>
    <message>
        <source>Machine of its programs</source>
        <translation>其程序所用的机床</translation>
    </message>
    <message>
        <source>Dialect of its programs (default: the machine&apos;s)</source>
        <translation>其程序的方言（默认：机床的方言）</translation>
    </message>
    <message>
        <source>Units of its programs: mm or inch</source>
        <translation>其程序的单位：mm 或 inch</translation>
    </message>
    <message>
        <source>Re-simulate a program on a project&apos;s setup and judge it</source>
        <translation>在项目的装夹上重新仿真程序并作出评判</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>NC 程序</translation>
    </message>
    <message>
        <source>Tool of the whole program (default: the project&apos;s tools by their numbers, or the tool of the first take)</source>
        <translation>整个程序的刀具（默认：按编号使用项目的刀具，或使用第一次录制的刀具）</translation>
    </message>
    <message>
        <source>Dialect of the program (default: the project&apos;s, or the machine&apos;s)</source>
        <translation>程序的方言（默认：项目的或机床的方言）</translation>
    </message>
    <message>
        <source>Largest allowed difference between the stock left on the part and what the project&apos;s paths leave, and largest excess at blended corners, mm; 0: not judged (default: 0.1, and the project&apos;s paths count only for programs that Burin posted)</source>
        <translation>零件上留下的残料与项目刀路所留残料之间允许的最大差值，以及圆滑过渡拐角处允许的最大残料，mm；0：不评判（默认：0.1，且项目的刀路只对 Burin 后处理的程序起作用）</translation>
    </message>
    <message>
        <source>Number of worst points that are judged on exact geometry</source>
        <translation>按精确几何评判的最差点的数量</translation>
    </message>
    <message>
        <source>Write the deviation map as a VTK file (.vtp), in the colours of the window</source>
        <translation>把偏差图写为 VTK 文件 (.vtp)，采用窗口中的颜色</translation>
    </message>
    <message>
        <source>View direction of the picture</source>
        <translation>图片的视图方向</translation>
    </message>
    <message>
        <source>Section plane: X=, Y= or Z= and its position, mm; the side towards the viewer is hidden</source>
        <translation>剖切面：X=、Y= 或 Z= 及其位置，mm；朝向观察者的一侧会隐藏</translation>
    </message>
    <message>
        <source>Transparency of the workpiece, %; shows the part inside it</source>
        <translation>工件的透明度，%；显示其中的零件</translation>
    </message>
    <message>
        <source>Tool axis: fixed (+Z), X,Y,Z towards the holder (3+2), or free (it follows the stylus)</source>
        <translation>刀具轴线：fixed (+Z)、指向刀柄的 X,Y,Z (3+2)，或 free（随触笔变化）</translation>
    </message>
    <message>
        <source>Clearance between the tool and the added fixtures and keep-out volumes, mm</source>
        <translation>刀具与所添加的夹具和禁入区之间的间隙，mm</translation>
    </message>
    <message>
        <source>Position of program zero in the machine&apos;s travel: X,Y,Z of the tip from its low end, mm; middle (of X and Y, Z up to the tool change height); or off</source>
        <translation>程序零点在机床行程中的位置：X,Y,Z，刀尖到行程低端的距离，mm；middle（X 和 Y 居中，Z 到换刀高度为止）；或 off</translation>
    </message>
    <message>
        <source>List and show materials; copy, add and delete your own. Every value states its source or that it is an estimate</source>
        <translation>列出和显示材料；复制、添加和删除自己的材料。每个数值都注明来源，或注明是估计值</translation>
    </message>
    <message>
        <source>List all materials with their specific cutting energies</source>
        <translation>列出所有材料及其单位切削能</translation>
    </message>
    <message>
        <source>Print the file of a material (JSON), in the form that add reads</source>
        <translation>输出材料的文件 (JSON)，格式与 add 读取的相同</translation>
    </message>
    <message>
        <source>Add a material to your own; what a card lacks is filled with estimates and told</source>
        <translation>添加一种自己的材料；材料卡中缺少的数值以估计值补全并告知</translation>
    </message>
    <message>
        <source>Material file (JSON), or material card of FreeCAD (.FCMat)</source>
        <translation>材料文件 (JSON)，或 FreeCAD 的材料卡 (.FCMat)</translation>
    </message>
    <message>
        <source>Copy a material to one of your own</source>
        <translation>把材料复制为自己的材料</translation>
    </message>
    <message>
        <source>Material to copy</source>
        <translation>要复制的材料</translation>
    </message>
    <message>
        <source>Delete one of your own materials</source>
        <translation>删除一种自己的材料</translation>
    </message>
    <message>
        <source>Replace a material that has this ID already</source>
        <translation>替换已有此 ID 的材料</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>File to write: .srle (volume file), .nrrd with a table beside it, .stl, .ply or .3mf (surface)</source>
        <translation>要写入的文件：.srle（体积文件）、.nrrd 及其旁边的表格、.stl、.ply 或 .3mf（表面）</translation>
    </message>
    <message>
        <source>Axis that the runs lie along: x, y or z</source>
        <translation>游程所沿的轴：x、y 或 z</translation>
    </message>
    <message>
        <source>The stock before anything was milled</source>
        <translation>尚未铣削的毛坯</translation>
    </message>
    <message>
        <source>Volume file, or voxel array</source>
        <translation>体积文件或体素数组</translation>
    </message>
    <message>
        <source>Table of the materials that the values of a voxel array mean (JSON)</source>
        <translation>体素数组各数值对应的材料表 (JSON)</translation>
    </message>
    <message>
        <source>Convert, combine and measure volumes of voxels; export the workpiece</source>
        <translation>转换、组合和测量体素体积；导出工件</translation>
    </message>
    <message>
        <source>Volume file, or voxel array (NRRD, or raw with a header in JSON)</source>
        <translation>体积文件，或体素数组（NRRD，或带 JSON 头的原始数据）</translation>
    </message>
    <message>
        <source>Write a volume in another form</source>
        <translation>以另一种形式写入体积</translation>
    </message>
    <message>
        <source>What belongs to one volume or the other</source>
        <translation>属于其中任一体积的部分</translation>
    </message>
    <message>
        <source>What belongs to both volumes</source>
        <translation>同时属于两个体积的部分</translation>
    </message>
    <message>
        <source>What belongs to the first volume alone</source>
        <translation>只属于第一个体积的部分</translation>
    </message>
    <message>
        <source>The voxels that have an empty neighbour</source>
        <translation>有空相邻体素的体素</translation>
    </message>
    <message>
        <source>The same volume with its runs along another axis</source>
        <translation>同一体积，游程沿另一轴</translation>
    </message>
    <message>
        <source>The workpiece of a project, as its takes left it</source>
        <translation>项目的工件，即各次录制之后的样子</translation>
    </message>
    <message>
        <source>Volume, mass, centre and inertia of each material</source>
        <translation>每种材料的体积、质量、质心和惯量</translation>
    </message>
    <message>
        <source>Whether two volumes share space, touch or are apart</source>
        <translation>两个体积是重叠、接触还是分离</translation>
    </message>
    <message>
        <source>Box of the stock whatever the part: X0,Y0,Z0,X1,Y1,Z1, mm</source>
        <translation>与零件无关的方形毛坯：X0,Y0,Z0,X1,Y1,Z1，mm</translation>
    </message>
    <message>
        <source>Round stock whatever the part: X,Y,Z,AX,AY,AZ,RADIUS,HEIGHT, mm</source>
        <translation>与零件无关的圆柱毛坯：X,Y,Z,AX,AY,AZ,半径,高度，mm</translation>
    </message>
    <message>
        <source>Axis of a cylinder around the part: x, y, z, or X,Y,Z</source>
        <translation>围绕零件的圆柱的轴线：x、y、z，或 X,Y,Z</translation>
    </message>
    <message>
        <source>Layer of the stock: NAME=MATERIAL,AXIS,FROM,TO, mm; a later one has the place; may be repeated</source>
        <translation>毛坯的材料层：名称=材料,轴,起点,终点，mm；重叠处以后一层为准；可重复使用</translation>
    </message>
    <message>
        <source>Value of a layer that changes: LAYER:VALUE=FORMULA of X, Y and Z, mm; may be repeated</source>
        <translation>材料层中变化的数值：层:数值=公式（含 X、Y 和 Z），mm；可重复使用</translation>
    </message>
    <message>
        <source>The same by a table: LAYER:VALUE=AXIS:POSITION,VALUE;POSITION,VALUE…; may be repeated</source>
        <translation>同上，但用表格给定：层:数值=轴:位置,数值;位置,数值…；可重复使用</translation>
    </message>
    <message>
        <source>Bands that the values of a graded layer are sorted into</source>
        <translation>渐变材料层的数值划分成的级数</translation>
    </message>
    <message>
        <source>No part is needed: nothing pushes the tool back</source>
        <translation>不需要零件：没有什么会把刀具推回</translation>
    </message>
    <message>
        <source>Shape of the stock: box, cylinder, solids or file</source>
        <translation>毛坯的形状：box、cylinder、solids 或 file</translation>
    </message>
    <message>
        <source>Stock as a file has it: a volume file (.srle), a voxel array (NRRD, or raw data with a JSON header), or a model whose solids are of --material</source>
        <translation>文件中的毛坯：体积文件 (.srle)、体素数组（NRRD，或带 JSON 头的原始数据），或模型，其实体的材料为 --material</translation>
    </message>
    <message>
        <source>JSON table of the materials that the values of a voxel array mean</source>
        <translation>体素数组各数值对应的材料的 JSON 表</translation>
    </message>
    <message>
        <source>Make a tool of models of its flutes and its shank: what they sweep while the spindle turns. Axis +Z through the origin, towards the holder</source>
        <translation>由刃部和刀杆的模型生成刀具：即主轴旋转时它们扫过的形状。轴线 +Z 通过原点，指向刀柄</translation>
    </message>
    <message>
        <source>ID of the new tool</source>
        <translation>新刀具的 ID</translation>
    </message>
    <message>
        <source>The same of the shank (default: the shank of --like)</source>
        <translation>同上，用于刀杆（默认：--like 的刀杆）</translation>
    </message>
    <message>
        <source>Tool from which the new one takes number, teeth, limits and holder</source>
        <translation>新刀具的编号、齿数、极限和刀柄取自此刀具</translation>
    </message>
    <message>
        <source>Name of the tool (default: its ID)</source>
        <translation>刀具的名称（默认：其 ID）</translation>
    </message>
    <message>
        <source>T word (default: that of --like)</source>
        <translation>T 字（默认：--like 的 T 字）</translation>
    </message>
    <message>
        <source>Distance of the profile from what the flutes sweep, mm, at most; more where 48 lines don&apos;t do</source>
        <translation>轮廓与刃部扫过形状之间的最大距离，mm；48 条线不够时会更大</translation>
    </message>
    <message>
        <source>Replace your tool of this ID</source>
        <translation>替换自己的刀具中此 ID 的刀具</translation>
    </message>
    <message>
        <source>List all tools with their numbers and diameters</source>
        <translation>列出所有刀具及其编号和直径</translation>
    </message>
    <message>
        <source>Print the file of a tool (JSON), in the form that add reads</source>
        <translation>输出刀具的文件 (JSON)，格式与 add 读取的相同</translation>
    </message>
    <message>
        <source>Add a tool to your own; every value is checked</source>
        <translation>添加一把自己的刀具；每个数值都会检查</translation>
    </message>
    <message>
        <source>Copy a tool to one of your own</source>
        <translation>把刀具复制为自己的刀具</translation>
    </message>
    <message>
        <source>Tool to copy</source>
        <translation>要复制的刀具</translation>
    </message>
    <message>
        <source>Delete one of your own tools</source>
        <translation>删除一把自己的刀具</translation>
    </message>
    <message>
        <source>Unit of the machine that reads the table</source>
        <translation>读取该表的机床所用的单位</translation>
    </message>
    <message>
        <source>Tool file (JSON), or a FreeCAD tool bit (*.fctb)</source>
        <translation>刀具文件（JSON），或 FreeCAD 刀具文件（*.fctb）</translation>
    </message>
    <message>
        <source>Number or name of the setup to work in (default: the first)</source>
        <translation>操作所在装夹的编号或名称（默认：第一个）</translation>
    </message>
    <message>
        <source>Another part: STEP, IGES, BREP, or a mesh</source>
        <translation>另一个零件：STEP、IGES、BREP 或网格</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF or OFF file; with --free-carving it may be left out</source>
        <translation>STEP、IGES、BREP、STL、3MF、OBJ、PLY、AMF 或 OFF 文件；使用 --free-carving 时可省略</translation>
    </message>
    <message>
        <source>Mirror the part across x, y or z first. It is then another part than the one in the file</source>
        <translation>先将零件沿 x、y 或 z 镜像。此后它与文件中的零件不再是同一个零件</translation>
    </message>
    <message>
        <source>Millimetres per unit of a file that states none (STL, OBJ, PLY, OFF)</source>
        <translation>未注明单位的文件（STL、OBJ、PLY、OFF）中每单位的毫米数</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP, STL, 3MF, OBJ, PLY, AMF or OFF file</source>
        <translation>STEP、IGES、BREP、STL、3MF、OBJ、PLY、AMF 或 OFF 文件</translation>
    </message>
    <message>
        <source>Show and change the setups of a project: placement of the part, fixtures, keep-out volumes, tool axis, machine and travel</source>
        <translation>显示和更改项目的装夹：零件的放置、夹具、禁入区、刀轴、机床和行程</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP or mesh file of the flutes, closed</source>
        <translation>刃部的 STEP、IGES、BREP 或网格文件，须封闭</translation>
    </message>
    <message>
        <source>Rotate the part so that a face points along an axis: X,Y,Z=AXIS with a point on the face in mm and x, -x, y, -y, z or -z (down). For a cylinder or cone its axis is used; may be repeated</source>
        <translation>旋转零件，使一个面朝向某个轴：X,Y,Z=AXIS，其中 X,Y,Z 为面上一点（mm），AXIS 为 x、-x、y、-y、z 或 -z（向下）。圆柱面或圆锥面取其轴线；可重复</translation>
    </message>
    <message>
        <source>Rotate the part about the centre of its bounding box: AXIS:DEGREES with x, y, z or X,Y,Z; after --align; may be repeated</source>
        <translation>将零件绕其包围盒中心旋转：AXIS:DEGREES，轴为 x、y、z 或 X,Y,Z；在 --align 之后执行；可重复</translation>
    </message>
    <message>
        <source>Move the part by X,Y,Z mm, after --turn</source>
        <translation>将零件移动 X,Y,Z mm，在 --turn 之后执行</translation>
    </message>
    <message>
        <source>Add a setup of this name. --align, --turn and --move place the part in it, relative to the setup before; its stock is the workpiece of that setup</source>
        <translation>添加一个以此命名的装夹。--align、--turn 和 --move 确定零件在其中的位置，相对于前一个装夹；其毛坯是前一个装夹的工件</translation>
    </message>
    <message>
        <source>Number or name of the setup that precedes the new one (default: --setup)</source>
        <translation>新装夹之前的那个装夹的编号或名称（默认：--setup）</translation>
    </message>
    <message>
        <source>Give the new setup a new stock with the same margins</source>
        <translation>为新装夹设置余量相同的新毛坯</translation>
    </message>
    <message>
        <source>Update the stock from the setup that it comes from</source>
        <translation>从毛坯所来自的装夹更新毛坯</translation>
    </message>
    <message>
        <source>Name of the setup</source>
        <translation>装夹的名称</translation>
    </message>
    <message>
        <source>Number or name of a setup to delete; only one without recordings, paths and programs</source>
        <translation>要删除的装夹的编号或名称；仅限没有录制、刀路和程序的装夹</translation>
    </message>
    <message>
        <source>Model of a fixture in the setup&apos;s frame (STEP, IGES, BREP, or a mesh); may be repeated</source>
        <translation>装夹坐标系中的夹具模型（STEP、IGES、BREP 或网格）；可重复</translation>
    </message>
    <message>
        <source>Box that the tool must not enter, X0,Y0,Z0,X1,Y1,Z1 in the setup&apos;s frame, mm; may be repeated</source>
        <translation>刀具不得进入的长方体，X0,Y0,Z0,X1,Y1,Z1，装夹坐标系，mm；可重复</translation>
    </message>
    <message>
        <source>Program zero: stock:X,Y,Z or part:X,Y,Z, each low, middle or high of its bounding box (stock:low,low,high is a corner of its top face); near:X,Y,Z, the part&apos;s vertex, middle of an edge or centre of a circle that is nearest; or coordinates X,Y,Z; all in the setup&apos;s frame, mm</source>
        <translation>程序零点：stock:X,Y,Z 或 part:X,Y,Z，各为包围盒的 low、middle 或 high（stock:low,low,high 是其顶面的一个角）；near:X,Y,Z，即零件上最近的顶点、边的中点或圆心；或坐标 X,Y,Z；均为装夹坐标系，mm</translation>
    </message>
    <message>
        <source>Work offset that stores program zero: G54 to G59, G59.1 to G59.3, or P1 to P300 (G54.1 P or G154 P)</source>
        <translation>存放程序零点的工件偏置：G54 至 G59、G59.1 至 G59.3，或 P1 至 P300（G54.1 P 或 G154 P）</translation>
    </message>
    <message>
        <source>Write the setup sheet of a project as one HTML page: pictures, zero, stock, fixtures, tools, times and findings</source>
        <translation>将项目的装夹单写成一个 HTML 页面：图片、零点、毛坯、夹具、刀具、时间和问题</translation>
    </message>
    <message>
        <source>Page to write (.html)</source>
        <translation>要写入的页面（.html）</translation>
    </message>
    <message>
        <source>Units of the page: mm or inch (default: the program&apos;s)</source>
        <translation>页面的单位：mm 或 inch（默认：程序的单位）</translation>
    </message>
    <message>
        <source>File to read</source>
        <translation>要读取的文件</translation>
    </message>
    <message>
        <source>Tool that lends what the file does not say: holder, stick-out, limits; of a LinuxCNC table the form</source>
        <translation>用来补足文件未说明内容的刀具：刀柄、伸出长度、极限值；对 LinuxCNC 刀具表还有刀形</translation>
    </message>
    <message>
        <source>Unit of a LinuxCNC table, which states none</source>
        <translation>LinuxCNC 刀具表的单位（表中不注明）</translation>
    </message>
    <message>
        <source>Replace your own tools of these IDs</source>
        <translation>替换自己的刀具中 ID 相同的刀具</translation>
    </message>
    <message>
        <source>List what would be added; keep nothing</source>
        <translation>列出将会添加的内容；不保存任何内容</translation>
    </message>
    <message>
        <source>Make a path from takes or of a computed pass, with the standard edits</source>
        <translation>由录制或一次计算走刀生成刀路，带标准编辑步骤</translation>
    </message>
    <message>
        <source>Name of the path (default: &quot;path&quot;, or what the pass is)</source>
        <translation>刀路的名称（默认：“path”，或走刀的类型）</translation>
    </message>
    <message>
        <source>Tool of the pass (default: the tool of the path)</source>
        <translation>走刀的刀具（默认：刀路的刀具）</translation>
    </message>
    <message>
        <source>Stock to leave on the part, mm</source>
        <translation>零件上要留的余量，mm</translation>
    </message>
    <message>
        <source>Instead of --step-over: height of the ridges between rows, mm</source>
        <translation>代替 --step-over：行与行之间残脊的高度，mm</translation>
    </message>
    <message>
        <source>Direction of parallel rows, degrees from X</source>
        <translation>平行行的方向，从 X 起算的角度（度）</translation>
    </message>
    <message>
        <source>Move the drawing by X,Y, mm</source>
        <translation>将图形移动 X,Y，mm</translation>
    </message>
    <message>
        <source>Id of the pass, as &quot;path P list --json&quot; shows it</source>
        <translation>走刀的 id，如“path P list --json”所示</translation>
    </message>
    <message>
        <source>Distance between rows or loops, or between the heights of a waterline, mm (default: 0.4 of the diameter for roughing, 1/15 for finishing)</source>
        <translation>行或圈的间距，或等高各层的间距，mm（默认：粗加工为直径的 0.4，精加工为 1/15）</translation>
    </message>
    <message>
        <source>levels: largest height of the steps left on slopes, mm (default: a tenth of the diameter)</source>
        <translation>levels：斜面上残留台阶的最大高度，mm（默认：直径的十分之一）</translation>
    </message>
    <message>
        <source>Only where the part is at least this steep, degrees</source>
        <translation>仅限零件陡度不小于此值之处，度</translation>
    </message>
    <message>
        <source>Only where the part is at most this steep, degrees</source>
        <translation>仅限零件陡度不大于此值之处，度</translation>
    </message>
    <message>
        <source>Height at which the pass begins, mm (default: the top of the stock)</source>
        <translation>走刀开始的高度，mm（默认：毛坯顶面）</translation>
    </message>
    <message>
        <source>Lowest height of the tip, mm (default: the lowest point of the part; for face its top)</source>
        <translation>刀尖的最低高度，mm（默认：零件的最低点；face 为其顶面）</translation>
    </message>
    <message>
        <source>Cut all rows in one direction</source>
        <translation>所有行沿同一方向切削</translation>
    </message>
    <message>
        <source>profile: inside the outline of --area instead of around it</source>
        <translation>profile：在 --area 轮廓的内侧，而不是绕其外侧</translation>
    </message>
    <message>
        <source>Only rows where stock is left</source>
        <translation>仅限有残料的行</translation>
    </message>
    <message>
        <source>Area of the pass, in the coordinates of the setup: closed curves of a DXF or SVG drawing, or a JSON file with a request as &quot;path list --json&quot; prints it</source>
        <translation>走刀的区域，装夹坐标系：DXF 或 SVG 图形的封闭曲线，或含有“path list --json”所输出请求的 JSON 文件</translation>
    </message>
    <message>
        <source>Unit of the drawing (default: the unit that it states)</source>
        <translation>图形的单位（默认：图形注明的单位）</translation>
    </message>
    <message>
        <source>Diameter of the brush of --paint, mm</source>
        <translation>--paint 的画笔直径，mm</translation>
    </message>
    <message>
        <source>The area limits where rows touch the part, not where the tip goes (always with --face and --paint)</source>
        <translation>区域限定的是各行与零件的接触位置，而不是刀尖经过的位置（使用 --face 和 --paint 时总是如此）</translation>
    </message>
    <message>
        <source>Compute the passes of a path again, as each was asked for</source>
        <translation>按各次走刀原来的要求重新计算刀路的走刀</translation>
    </message>
    <message>
        <source>Compute it in place of the pass with this id</source>
        <translation>替换此 id 的走刀，在其位置上计算</translation>
    </message>
    <message>
        <source>Area: the face of the part at X,Y,Z, mm, within 1 mm; can be given several times</source>
        <translation>区域：零件在 X,Y,Z 处的面，mm，误差 1 mm 以内；可多次给出</translation>
    </message>
    <message>
        <source>Area: painted by the strokes of these takes, as wide as --brush</source>
        <translation>区域：由这些录制的笔画涂出，宽度为 --brush</translation>
    </message>
    <message>
        <source>Largest depth of a level, or of a peck when drilling, mm (default: what material, tool and spindle can take; holes deeper than 3 diameters: one diameter)</source>
        <translation>每层的最大切深，或钻孔时每次啄钻的最大深度，mm（默认：材料、刀具和主轴所能承受的值；深于 3 倍直径的孔：一倍直径）</translation>
    </message>
    <message>
        <source>profile: number of holding tabs left on each outline</source>
        <translation>profile：每条轮廓上保留的连接片数量</translation>
    </message>
    <message>
        <source>Width of a holding tab, mm</source>
        <translation>连接片的宽度，mm</translation>
    </message>
    <message>
        <source>Height of a holding tab above the lowest level, mm</source>
        <translation>连接片高出最低层的高度，mm</translation>
    </message>
    <message>
        <source>pocket, profile: cut into the inner corners of the area, so that a part with square corners fits</source>
        <translation>pocket、profile：切入区域的内角，使带直角的零件能够装入</translation>
    </message>
    <message>
        <source>Curves to engrave, that the rows of flow follow, or beside which pencil looks for edges: DXF, SVG or JSON</source>
        <translation>要雕刻的曲线、flow 各行所跟随的曲线，或 pencil 在其旁边查找边的曲线：DXF、SVG 或 JSON</translation>
    </message>
    <message>
        <source>Takes whose strokes the rows of flow follow, or beside which pencil looks for edges</source>
        <translation>flow 各行跟随其笔画的录制，或 pencil 在其笔画旁边查找边的录制</translation>
    </message>
    <message>
        <source>Only estimate the length and time of the pass; change nothing</source>
        <translation>只估算走刀的长度和时间；不作任何更改</translation>
    </message>
    <message>
        <source>Move a pass or take to another position in its path</source>
        <translation>将走刀或录制移到刀路中的另一位置</translation>
    </message>
    <message>
        <source>Position, from 0: the first is milled first</source>
        <translation>位置，从 0 起：第一个最先铣削</translation>
    </message>
    <message>
        <source>One of the device&apos;s modes</source>
        <translation>设备的模式之一</translation>
    </message>
    <message>
        <source>Share of the cutting force that is felt with a device, or was felt while a trace was recorded that does not state it, 0 to 1</source>
        <translation>使用设备时手感所得切削力的比例，或录制未注明该比例的轨迹时手感所得的比例，0 到 1</translation>
    </message>
    <message>
        <source>Test this device: reads it and reports rate, intervals, motion and buttons</source>
        <translation>测试此设备：读取设备并报告频率、间隔、运动和按钮</translation>
    </message>
    <message>
        <source>Duration, s</source>
        <translation>持续时间，s</translation>
    </message>
    <message>
        <source>Push up with this force, N, while its first button is held; at most a fifth of its maximum force</source>
        <translation>按住其第一个按钮时，以此力（N）向上推；最多为其最大力的五分之一</translation>
    </message>
    <message>
        <source>Ignore the project&apos;s guides (with a device)</source>
        <translation>忽略项目的导向（使用设备时）</translation>
    </message>
    <message>
        <source>Read the part again from this file: roles and materials of bodies stay by their names, and so do setups, recordings and paths</source>
        <translation>从此文件重新读取零件：实体的角色和材料按名称保留，装夹、录制和刀路也保留</translation>
    </message>
    <message>
        <source>Mill on from a moment (TAKE:SECONDS, or TAKE for its end); what was recorded after it is switched off (&quot;burin take on&quot; switches it on again)</source>
        <translation>从某一时刻起继续铣削（TAKE:SECONDS，或用 TAKE 表示其末尾）；此后录制的内容会关闭（“burin take on”可重新启用）</translation>
    </message>
    <message>
        <source>Take, by its number in &quot;burin info&quot;</source>
        <translation>录制，按“burin info”中的编号</translation>
    </message>
    <message>
        <source>Workpiece and paths are made without it, until it is switched on again; nothing is erased</source>
        <translation>生成工件和刀路时不计入它，直到重新启用；不会抹去任何内容</translation>
    </message>
    <message>
        <source>It counts again</source>
        <translation>重新计入</translation>
    </message>
    <message>
        <source>Its new name</source>
        <translation>新名称</translation>
    </message>
    <message>
        <source>The workpiece at a moment: TAKE:SECONDS, or TAKE for its end</source>
        <translation>某一时刻的工件：TAKE:SECONDS，或用 TAKE 表示其末尾</translation>
    </message>
    <message>
        <source>Write the workpiece that the program leaves, in the forms of &quot;volume export&quot;</source>
        <translation>写出程序加工后的工件，格式同“volume export”</translation>
    </message>
    <message>
        <source>With --workpiece: as it stands at this time of the program, s</source>
        <translation>与 --workpiece 合用：程序运行到此时间时的工件，s</translation>
    </message>
    <message>
        <source>Beginning of the part, s from the start of the take (default: its start)</source>
        <translation>片段的起点，从录制开始算起的秒数，s（默认：录制的起点）</translation>
    </message>
    <message>
        <source>End of the part, s from the start of the take (default: its end)</source>
        <translation>片段的终点，从录制开始算起的秒数，s（默认：录制的终点）</translation>
    </message>
    <message>
        <source>Rename it</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Make paths of a program of another system (G-code or APT/CL), one for each tool</source>
        <translation>由其他系统的程序（G-code 或 APT/CL）生成刀路，每把刀具一条</translation>
    </message>
    <message>
        <source>Program to read</source>
        <translation>要读取的程序</translation>
    </message>
    <message>
        <source>Tool of the whole program (default: the project&apos;s tools by their numbers)</source>
        <translation>整个程序的刀具（默认：按编号对应项目的刀具）</translation>
    </message>
    <message>
        <source>Name of the path (default: the program&apos;s file)</source>
        <translation>刀路的名称（默认：程序的文件名）</translation>
    </message>
    <message>
        <source>Colour the first path by this quantity, with a scale, instead of by its moves</source>
        <translation>按此物理量为第一条刀路着色并显示色标，而不是按移动类型</translation>
    </message>
    <message>
        <source>X,Y,Z on the part, mm, in the coordinates of the setup; the nearest face is measured</source>
        <translation>零件上的 X,Y,Z，mm，装夹坐标系；测量最近的面</translation>
    </message>
    <message>
        <source>The same of a second face: distances and angle</source>
        <translation>第二个面的同类点：距离和角度</translation>
    </message>
    <message>
        <source>Colour the workpiece by the stock that is left on the part, with a scale</source>
        <translation>按零件上的残料为工件着色并显示色标</translation>
    </message>
    <message>
        <source>State how well it was milled: times, tries to gouge, smoothness, force, removal and stock left, compared with a reference; nothing is changed</source>
        <translation>说明铣削得如何：时间、过切尝试次数、平滑度、力、去除量和残料，并与参考录制比较；不做任何更改</translation>
    </message>
    <message>
        <source>Take to compare it with, by its number; it may be switched off</source>
        <translation>用于比较的录制（按编号）；可以是已停用的</translation>
    </message>
    <message>
        <source>Add an edit, a computed pass or a take to a path</source>
        <translation>向刀路添加编辑步骤、计算的走刀或录制</translation>
    </message>
    <message>
        <source>Replay it earlier or later among the takes of its setup; the workpiece at the end and the paths stay</source>
        <translation>使其在所属装夹的录制中更早或更晚重放；最终的工件和刀路不变</translation>
    </message>
    <message>
        <source>Just before this take, by its number</source>
        <translation>放到此编号的录制之前</translation>
    </message>
    <message>
        <source>To this position in the order of the takes, from 1</source>
        <translation>放到录制顺序中的此位置，从 1 开始</translation>
    </message>
    <message>
        <source>Number of the path to compare with</source>
        <translation>要与之比较的刀路编号</translation>
    </message>
    <message>
        <source>Compare with the path without this edit: its position in the list, from 0</source>
        <translation>与去掉此编辑步骤的刀路比较：它在列表中的位置，从 0 开始</translation>
    </message>
    <message>
        <source>Compare with the path without its edits, as it was recorded or computed</source>
        <translation>与不含编辑步骤的刀路比较，即录制或计算时的样子</translation>
    </message>
    <message>
        <source>Compare a path with another one, or with a version of itself</source>
        <translation>将刀路与另一条刀路或其自身的另一版本比较</translation>
    </message>
    <message>
        <source>Distance in mm beyond which parts of the paths count as different</source>
        <translation>超过此距离（mm）的刀路部分视为不同</translation>
    </message>
    <message>
        <source>List the faces of the part with gouge, stock left and share in tolerance, the worst first</source>
        <translation>列出零件的面及其过切、残料和公差内的比例，最差的在前</translation>
    </message>
    <message>
        <source>Write the list of --faces as a table (.csv)</source>
        <translation>把 --faces 的列表写成表格 (.csv)</translation>
    </message>
    <message>
        <source>Stock to leave on the part, mm: within tolerance in the map&apos;s colours and on faces</source>
        <translation>零件上要留的余量，mm：在偏差图的颜色中和各面上算在公差内</translation>
    </message>
    <message>
        <source>Take to mill last in the path; copies of takes are added to a path only this way</source>
        <translation>在刀路中最后铣削的录制；录制的副本只能以这种方式加入刀路</translation>
    </message>
    <message>
        <source>Delete a path with its computed passes, or remove one pass or one take from it; takes stay in the project</source>
        <translation>删除刀路及其计算的走刀，或从中移除一个走刀或一段录制；录制保留在项目中</translation>
    </message>
    <message>
        <source>Take to remove from the path</source>
        <translation>要从刀路中移除的录制</translation>
    </message>
    <message>
        <source>Copy it with its strokes and what is switched off, after all other takes; no path mills the copy until &quot;burin path P apply PATH --take&quot; adds it</source>
        <translation>复制录制，连同其笔画和停用部分，放在所有其他录制之后；用“burin path P apply PATH --take”加入之前，没有刀路铣削该副本</translation>
    </message>
    <message>
        <source>Show what the axes and buttons of this device do; changes are kept for the window and the command mill</source>
        <translation>显示此设备的轴和按钮的作用；更改会保留，供窗口和 mill 命令使用</translation>
    </message>
    <message>
        <source>Assign an axis: N=MOTION[,reversed][,gain=G][,dead=SHARE], for example 2=z,reversed,gain=0.5,dead=0.1</source>
        <translation>分配轴：N=运动[,reversed][,gain=G][,dead=比例]，例如 2=z,reversed,gain=0.5,dead=0.1</translation>
    </message>
    <message>
        <source>Assign a button: N=ACTION, for example 2=lift; mill, undo, clutch and others</source>
        <translation>分配按钮：N=动作，例如 2=lift；还有 mill、undo、clutch 等</translation>
    </message>
    <message>
        <source>Begin with the usual assignment and without calibration</source>
        <translation>从常用分配开始，不带标定</translation>
    </message>
    <message>
        <source>Measure the axes of this device: two seconds at rest, then in motion; rest, ends and dead zone are kept</source>
        <translation>测量此设备的轴：先静止两秒，再移动；保留静止位置、两端和死区</translation>
    </message>
    <message>
        <source>Time for moving every axis to its ends, s</source>
        <translation>将每个轴移动到两端的时间，s</translation>
    </message>
    <message>
        <source>Colour of a body, or of all bodies of an assembly: BODY=#RRGGBB; may be repeated</source>
        <translation>实体的颜色，或装配体中所有实体的颜色：实体=#RRGGBB；可重复使用</translation>
    </message>
    <message>
        <source>List the library of fixtures: kinds, sizes, their defaults and ranges. Add one to a project with burin setup --add-fixture</source>
        <translation>列出夹具库：类型、尺寸、其默认值和范围。用 burin setup --add-fixture 把夹具添加到项目中</translation>
    </message>
    <message>
        <source>Switch takes, or parts of them, off and on; rename, move, copy, score and measure them</source>
        <translation>停用或启用录制或其一部分；重命名、移动、复制录制，并评分和测量</translation>
    </message>
    <message>
        <source>Measure the distance of its tool from the part over time, negative where the tool is in the part; nothing is changed</source>
        <translation>测量其刀具到零件的距离随时间的变化，刀具进入零件处为负；不做任何更改</translation>
    </message>
    <message>
        <source>Write time and least distance of every ten samples as CSV</source>
        <translation>把每十个采样点的时间和最小距离写为 CSV</translation>
    </message>
    <message>
        <source>Write tools for other programs: a LinuxCNC tool table (*.tbl), a Fusion library (*.tools), a CAMotics table (*.ctbl), a FreeCAD library with its bits in a folder Bit (*.fctl), a FreeCAD tool bit (*.fctb), or Burin&apos;s own form (*.json)</source>
        <translation>为其他程序写出刀具：LinuxCNC 刀具表（*.tbl）、Fusion 刀具库（*.tools）、CAMotics 刀具表（*.ctbl）、FreeCAD 刀具库及其 Bit 文件夹中的刀头（*.fctl）、FreeCAD 刀头（*.fctb），或 Burin 自己的格式（*.json）</translation>
    </message>
    <message>
        <source>Tools (default: all, or those of --library)</source>
        <translation>刀具（默认：全部，或 --library 中的刀具）</translation>
    </message>
    <message>
        <source>Tool library</source>
        <translation>刀具库</translation>
    </message>
    <message>
        <source>List the tool libraries with the number of their tools</source>
        <translation>列出刀具库及其刀具数量</translation>
    </message>
    <message>
        <source>Add a tool library</source>
        <translation>新建刀具库</translation>
    </message>
    <message>
        <source>Rename one of your tool libraries</source>
        <translation>重命名您的一个刀具库</translation>
    </message>
    <message>
        <source>Delete one of your tool libraries</source>
        <translation>删除您的一个刀具库</translation>
    </message>
    <message>
        <source>Delete its tools as well</source>
        <translation>同时删除其中的刀具</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Add or change a preset of feeds and speeds of one of your own tools. Paths use the first preset for the material of the stock, without one the first for any material, without one the values that the material states</source>
        <translation>为您自己的刀具添加或修改进给和转速预设。刀路使用毛坯材料的第一个预设；若没有，则使用任意材料的第一个预设；再没有，则使用材料给出的数值</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>预设的名称</translation>
    </message>
    <message>
        <source>Material that it is for, or any</source>
        <translation>预设适用的材料，或 any</translation>
    </message>
    <message>
        <source>Speed of the spindle, 1/min</source>
        <translation>主轴转速，1/min</translation>
    </message>
    <message>
        <source>Feed, mm/min</source>
        <translation>进给，mm/min</translation>
    </message>
    <message>
        <source>Feed per tooth instead, mm</source>
        <translation>改用每齿进给量，mm</translation>
    </message>
    <message>
        <source>Plunge feed, mm/min; 0: the share of the feed that the material states</source>
        <translation>下刀进给，mm/min；0：材料给出的进给比例</translation>
    </message>
    <message>
        <source>Depth of a level, mm; 0: what material, tool and spindle can take</source>
        <translation>每层切深，mm；0：材料、刀具和主轴所能承受的值</translation>
    </message>
    <message>
        <source>Distance between the loops of a level, mm; 0: a share of the diameter</source>
        <translation>同层各圈之间的行距，mm；0：直径的一定比例</translation>
    </message>
    <message>
        <source>Coolant, or what the material advises</source>
        <translation>冷却液，或材料建议的方式</translation>
    </message>
    <message>
        <source>Prefer it to the tool&apos;s other presets</source>
        <translation>优先于该刀具的其他预设</translation>
    </message>
    <message>
        <source>Delete the preset</source>
        <translation>删除该预设</translation>
    </message>
    <message>
        <source>The tool does not turn (scraper, planing blade): the models themselves cut, and the profile only keeps them out of the part</source>
        <translation>刀具不旋转（刮刀、刨刀）：由模型本身切削，轮廓只用来把它们挡在零件之外</translation>
    </message>
    <message>
        <source>With --fixed: angle from X of the setup to X of the models, degrees, counterclockwise seen from above</source>
        <translation>与 --fixed 一起用：从装夹的 X 到模型的 X 的角度（度），从上方看为逆时针</translation>
    </message>
    <message>
        <source>List and show tools; copy, add and delete your own, and make them of models. Tools form libraries. Every tool states the source of its values</source>
        <translation>列出并显示刀具；复制、添加和删除您自己的刀具，并由模型生成刀具。刀具分属刀具库。每把刀具都注明其数值的来源</translation>
    </message>
    <message>
        <source>Tool library: all, starter (what Burin is shipped with), mine (your own tools that are in no other), or one that you have named (default: all; of new tools mine)</source>
        <translation>刀具库：all（全部）、starter（Burin 自带）、mine（不在其他刀具库中的自有刀具），或您命名的刀具库（默认：all；新刀具为 mine）</translation>
    </message>
    <message>
        <source>Fixture of the library: its kind, then where it would be clicked on, and sizes: &quot;step-clamp at=X,Y turn=DEGREES SIZE=MM&quot;; place=X,Y,Z moves its origin. Kinds and sizes: burin fixtures; may be repeated</source>
        <translation>夹具库中的夹具：先写类型，再写单击的位置和尺寸：&quot;step-clamp at=X,Y turn=度数 尺寸=毫米&quot;；place=X,Y,Z 移动其原点。类型和尺寸见 burin fixtures；可重复使用</translation>
    </message>
    <message>
        <source>drill, thread: a hole at X,Y, mm, or by its number in &quot;info --json&quot;; can be given several times (default: every upright hole of the part that fits the drill, or has the diameter of the thread)</source>
        <translation>drill、thread：位于 X,Y（mm）的孔，或其在“info --json”中的编号；可给出多次（默认：零件上所有适合该钻头、或直径等于螺纹大径的竖直孔）</translation>
    </message>
    <message>
        <source>thread: pitch, mm</source>
        <translation>thread：螺距，mm</translation>
    </message>
    <message>
        <source>thread: instead of --pitch: threads per inch</source>
        <translation>thread：每英寸牙数，代替 --pitch</translation>
    </message>
    <message>
        <source>thread: once more at full depth</source>
        <translation>thread：以全深再走一遍</translation>
    </message>
    <message>
        <source>thread: left-handed</source>
        <translation>thread：左旋</translation>
    </message>
    <message>
        <source>thread: conventional instead of climb milling</source>
        <translation>thread：逆铣而非顺铣</translation>
    </message>
    <message>
        <source>Compute a pass: levels (roughing), pocket, profile, face, parallel, radial, spiral, flow (rows that follow --lead or --lines), waterline, scallop, pencil (concave edges), rest (what is left), engrave, drill, thread</source>
        <translation>计算一次走刀：levels（分层粗加工）、pocket（型腔）、profile（轮廓）、face（面铣）、parallel（平行）、radial（放射）、spiral（螺旋）、flow（流线，各行跟随 --lead 或 --lines）、waterline（等高）、scallop（等残高）、pencil（清根，凹边）、rest（残料加工）、engrave（雕刻）、drill（钻孔）、thread（铣螺纹）</translation>
    </message>
    <message>
        <source>Role of a body, or of all bodies of an assembly (by its path): BODY=part, stock, insert, protected-insert, fixture or ignored; may be repeated</source>
        <translation>实体的角色，或装配体（按其路径）中所有实体的角色：实体=part、stock、insert、protected-insert、fixture 或 ignored；可重复使用</translation>
    </message>
    <message>
        <source>Material of a body, or of all bodies of an assembly: BODY=NAME; may be repeated</source>
        <translation>实体的材料，或装配体中所有实体的材料：实体=名称；可重复使用</translation>
    </message>
    <message>
        <source>Unit of the model, whatever its file states: mm, cm, m, inch, foot, mil, a number of mm, or stated</source>
        <translation>模型的单位，不论文件如何注明：mm、cm、m、inch、foot、mil、毫米数，或 stated</translation>
    </message>
    <message>
        <source>Add tools of another program to your own: a Fusion library (*.tools, *.json), a FreeCAD library or bit (*.fctl, *.fctb), a CAMotics table (*.ctbl), a LinuxCNC table (*.tbl). Several tools become a library that has the name of the file, or are put into --library, which need not exist yet. What can&apos;t be held is listed</source>
        <translation>把其他程序的刀具加入您自己的刀具：Fusion 刀具库（*.tools、*.json）、FreeCAD 刀具库或刀头（*.fctl、*.fctb）、CAMotics 刀具表（*.ctbl）、LinuxCNC 刀具表（*.tbl）。多把刀具成为与文件同名的刀具库，或放入 --library 指定的刀具库（可尚不存在）。无法保存的内容会列出</translation>
    </message>
    <message>
        <source>Move your own tools to the library given by --library</source>
        <translation>把您自己的刀具移到 --library 指定的刀具库</translation>
    </message>
    <message>
        <source>Copy them instead; tools that Burin is shipped with can be copied, too</source>
        <translation>改为复制；Burin 自带的刀具也可以复制</translation>
    </message>
    <message>
        <source>thread: number of passes along the thread, each deeper than the one before</source>
        <translation>thread：沿螺纹走刀的次数，逐次加深</translation>
    </message>
    <message>
        <source>Let a gamepad vibrate or a joystick push while its first button is held: the strength rises to this share of its strongest effect within each second, 0 to 1</source>
        <translation>按住第一个按钮时让手柄振动或让摇杆推手：强度在每一秒内升至其最强效果的此比例，0 到 1</translation>
    </message>
    <message>
        <source>Ceiling of a gamepad&apos;s vibration or a joystick&apos;s force, as a share of its strongest effect, 0 to 1; 0: off</source>
        <translation>手柄振动或摇杆力的上限，为其最强效果的比例，0 到 1；0：关闭</translation>
    </message>
    <message>
        <source>Distance that shank and holder keep from the stock, mm (default: they are stopped when they touch it)</source>
        <translation>刀杆和刀柄与毛坯保持的距离，mm（默认：碰到毛坯时才停止）</translation>
    </message>
    <message>
        <source>Only the passes whose strokes (--lead, --hand) have changed since they were computed, as &quot;path P show&quot; reports them</source>
        <translation>只处理自计算以来其笔画（--lead、--hand）已改变的走刀，即&quot;path P show&quot;所报告的走刀</translation>
    </message>
    <message>
        <source>What rows do where takes earlier in the path have finished the part: ignore (default), keep-off, blend (go on over its border by --overlap, without a step), extend (flow: its rows continue those strokes sideways)</source>
        <translation>刀路中在前的录制已精加工之处各行如何处理：ignore（忽略，默认）、keep-off（避开）、blend（越过边界 --overlap，不留台阶）、extend（flow：各行向两侧延续这些笔画）</translation>
    </message>
    <message>
        <source>--hand blend: how far rows go on over the border, mm (default: 0.5)</source>
        <translation>--hand blend：各行越过边界的距离，mm（默认：0.5）</translation>
    </message>
    <message>
        <source>--hand: largest height that takes may have left on what counts as finished, mm (default: 0.02)</source>
        <translation>--hand：视为已精加工之处录制可留下的最大高度，mm（默认：0.02）</translation>
    </message>
    <message>
        <source>Touch off program zero as with an edge finder: X,Y,Z=AXIS moves the tip of the tool from a point in mm along x, -x, y, -y or -z until the stock stops it; the side that it touches becomes zero along this axis; may be repeated</source>
        <translation>如同使用寻边器对刀确定程序零点：X,Y,Z=轴 使刀尖从一点（mm）沿 x、-x、y、-y 或 -z 移动，直到被毛坯挡住；所碰到的侧面成为该轴的零点；可重复使用</translation>
    </message>
    <message>
        <source>Tool for --touch</source>
        <translation>用于 --touch 的刀具</translation>
    </message>
    <message>
        <source>Use the suggested gains for this device from now on, in the window and with &quot;mill&quot;</source>
        <translation>从现在起在窗口和“mill”中对该设备使用建议的增益</translation>
    </message>
    <message>
        <source>Never suggest a stiffness above this, N/mm; 0: no maximum of your own. Kept with --keep-gains</source>
        <translation>建议刚度不超过此值，N/mm；0：不设自己的最大值。与 --keep-gains 一起保存</translation>
    </message>
    <message>
        <source>Friction of the handle with the motors off, N, as a spring balance shows it; it limits the suggested stiffness. 0: not measured. Kept with --keep-gains</source>
        <translation>电机关闭时手柄的摩擦力，N，由弹簧秤测得；它限制建议刚度。0：未测量。与 --keep-gains 一起保存</translation>
    </message>
    <message>
        <source>Use the gains of this device again that were in use before the last change</source>
        <translation>重新使用该设备上次更改之前的增益</translation>
    </message>
    <message>
        <source>Measure the part or the workpiece: a face, its wall thickness, or how two faces lie to each other</source>
        <translation>测量零件或工件：一个面、其壁厚，或两个面的相互位置</translation>
    </message>
    <message>
        <source>Measure the workpiece as the takes left it: also its depth below the top of the stock, the width to the opposite side and the stock left on the part, each with its uncertainty</source>
        <translation>测量录制后的工件：还包括毛坯顶面以下的深度、到对面的宽度和零件上的残料，各值均带不确定度</translation>
    </message>
    <message>
        <source>Measure the workpiece of a volume file (.srle), as verify writes it</source>
        <translation>测量体素文件（.srle）中的工件，例如 verify 写出的文件</translation>
    </message>
    <message>
        <source>X,Y,Z into the workpiece: its thickness along this direction, too</source>
        <translation>指向工件内部的 X,Y,Z：同时测量沿此方向的厚度</translation>
    </message>
    <message>
        <source>Tool (default: that of the trace, otherwise ball-6)</source>
        <translation>刀具（默认：轨迹的刀具，否则为 ball-6）</translation>
    </message>
    <message>
        <source>Change a fixture of the library: &quot;NAME: SIZE=MM&quot;, with the same words; any other is moved: by=X,Y,Z, place=X,Y,Z (its lower corner), turn=DEGREES about Z through its middle; may be repeated</source>
        <translation>更改夹具库中的夹具：&quot;名称: 尺寸=毫米&quot;，词语同上；其他夹具则移动：by=X,Y,Z，place=X,Y,Z（其最低角点），turn=角度（绕过其中心的 Z 轴）；可重复使用</translation>
    </message>
    <message>
        <source>thread: an external thread on the stud at X,Y, mm, or by its number in &quot;info --json&quot;; can be given several times</source>
        <translation>thread：在位于 X,Y（mm）的凸台上铣外螺纹，或给出其在“info --json”中的编号；可给出多次</translation>
    </message>
    <message>
        <source>thread: on studs of the part instead of in its holes (default: every upright stud that has the minor diameter of the thread)</source>
        <translation>thread：在零件的凸台上，而非孔内（默认：每个直径等于螺纹小径的竖直凸台）</translation>
    </message>
    <message>
        <source>thread: a metric size, M3 to M24 or diameter and pitch, M8x1; the part&apos;s holes must be modelled with this diameter, its studs with the minor diameter that the mill cuts</source>
        <translation>thread：公制规格，M3 至 M24，或直径与螺距 M8x1；零件的孔须按此直径建模，凸台须按铣刀所铣的小径建模</translation>
    </message>
    <message>
        <source>thread: major diameter, mm (default: as each --hole or --stud has it)</source>
        <translation>thread：大径，mm（默认：由每个 --hole 或 --stud 得出）</translation>
    </message>
    <message>
        <source>engrave, drill: depth below the top of the stock, mm; thread: below the top of its hole or stud (default of drill and thread: to the bottom of the part&apos;s hole, or as far as the tool has room around the stud)</source>
        <translation>engrave、drill：自毛坯顶面向下的深度，mm；thread：自孔口或凸台顶面向下的深度（drill 和 thread 默认：到零件孔的底部，或到刀具在凸台周围有空间之处）</translation>
    </message>
</context>
<context>
    <name>HoleLabels</name>
    <message>
        <source>⌀ %1, %2 deep</source>
        <translation>⌀ %1，深 %2</translation>
    </message>
    <message>
        <source>%1 at X %2, Y %3</source>
        <translation>%1，位于 X %2，Y %3</translation>
    </message>
    <message>
        <source>stud ⌀ %1, %2 high</source>
        <translation>凸台 ⌀ %1，高 %2</translation>
    </message>
    <message>
        <source>no hole or stud of the part</source>
        <translation>不是零件的孔或凸台</translation>
    </message>
</context>
<context>
    <name>ImportFormat</name>
    <message>
        <source>STL binary</source>
        <translation>STL 二进制</translation>
    </message>
</context>
<context>
    <name>ImportNote</name>
    <message>
        <source>Lengths in %1 were converted: 1 %2 = %3 mm.</source>
        <translation>以 %1 为单位的长度已换算：1 %2 = %3 mm。</translation>
    </message>
    <message>
        <source>The file mixes %1 length units; each part was converted by its own.</source>
        <translation>文件混用了 %1 种长度单位；每个零件已按各自的单位换算。</translation>
    </message>
    <message>
        <source>A BREP file states no unit; millimetres were taken.</source>
        <translation>BREP 文件不注明单位；已按毫米处理。</translation>
    </message>
    <message>
        <source>An STL file states no unit; 1 unit = %1 mm was taken.</source>
        <translation>STL 文件不注明单位；已按 1 单位 = %1 mm 处理。</translation>
    </message>
    <message>
        <source>The part is %1 mm long: perhaps its unit is another one.</source>
        <translation>零件长 %1 mm：其单位可能有误。</translation>
    </message>
    <message>
        <source>%1 was invalid and was repaired.</source>
        <translation>%1 无效，已修复。</translation>
    </message>
    <message>
        <source>%1 is not fully valid, even after repair.</source>
        <translation>%1 在修复后仍不完全有效。</translation>
    </message>
    <message>
        <source>%1 does not close, so its inside is not certain.</source>
        <translation>%1 不封闭，因此其内部无法确定。</translation>
    </message>
    <message>
        <source>%1 was inside out and was turned.</source>
        <translation>%1 内外颠倒，已翻转。</translation>
    </message>
    <message>
        <source>1 loose face was sewn to a solid.</source>
        <translation>1 个散面已缝合为实体。</translation>
    </message>
    <message>
        <source>%1 loose faces were sewn to a solid.</source>
        <translation>%1 个散面已缝合为实体。</translation>
    </message>
    <message>
        <source>1 face outside of every solid was left out.</source>
        <translation>1 个不属于任何实体的面已略去。</translation>
    </message>
    <message>
        <source>%1 faces outside of every solid were left out.</source>
        <translation>%1 个不属于任何实体的面已略去。</translation>
    </message>
    <message>
        <source>Curves outside of every solid were left out.</source>
        <translation>不属于任何实体的曲线已略去。</translation>
    </message>
    <message>
        <source>%1: %2 plane faces that the mesher left incomplete were filled.</source>
        <translation>%1：网格划分未填满的 %2 个平面已补全。</translation>
    </message>
    <message>
        <source>%1 is not closed: %2 open edges. Its inside is not certain.</source>
        <translation>%1 不封闭：有 %2 条开放边。其内部无法确定。</translation>
    </message>
    <message>
        <source>%1: its mesh encloses %2 mm³, its exact surface %3 mm³.</source>
        <translation>%1：网格所围体积为 %2 mm³，精确曲面为 %3 mm³。</translation>
    </message>
    <message>
        <source>%1: its faces meet with gaps of up to %2 mm; there the mesh may be off by as much.</source>
        <translation>%1：各面之间有最大 %2 mm 的间隙；该处网格可能有同样大的偏差。</translation>
    </message>
    <message>
        <source>%1: %2 triangles were turned.</source>
        <translation>%1：已翻转 %2 个三角形。</translation>
    </message>
    <message>
        <source>%1 is not closed: %2 open edges. Its inside and volume are not certain.</source>
        <translation>%1 不封闭：有 %2 条开放边。其内部和体积无法确定。</translation>
    </message>
    <message>
        <source>%1 consists of %2 pieces that are not connected. Where they overlap, its volume counts twice.</source>
        <translation>%1 由 %2 个互不相连的部分组成。重叠之处体积会重复计算。</translation>
    </message>
    <message>
        <source>Data after the last triangle was left out.</source>
        <translation>最后一个三角形之后的数据已略去。</translation>
    </message>
    <message>
        <source>Body %1</source>
        <translation>实体 %1</translation>
    </message>
    <message>
        <source>Solid %1</source>
        <translation>实体 %1</translation>
    </message>
    <message>
        <source>The file ends without &quot;endsolid&quot;; what was read of it is whole.</source>
        <translation>文件末尾没有“endsolid”；已读取的内容是完整的。</translation>
    </message>
    <message>
        <source>%1 has no volume, so nothing of it can be protected.</source>
        <translation>%1 没有体积，因此无法保护其任何部分。</translation>
    </message>
    <message>
        <source>Parts are missing because they are in other files: %1. Copy those files into the folder of the model and import it again.</source>
        <translation>缺少部分零件，因为它们在其他文件中：%1。将这些文件复制到模型所在的文件夹，然后重新导入。</translation>
    </message>
    <message>
        <source>The file ends without &quot;endsolid&quot;; what was read of it is complete.</source>
        <translation>文件末尾没有“endsolid”；已读取的内容是完整的。</translation>
    </message>
    <message>
        <source>%1 has no faces and was left out.</source>
        <translation>%1 没有面，已略去。</translation>
    </message>
    <message>
        <source>The file states no unit; 1 unit = %1 mm was assumed.</source>
        <translation>文件未注明单位；已假定 1 单位 = %1 mm。</translation>
    </message>
    <message>
        <source>Colours are stored in another file, %1, and were not imported.</source>
        <translation>颜色存放在另一个文件 %1 中，未导入。</translation>
    </message>
    <message>
        <source>The file states the unit %1 (%2 mm); 1 unit = %3 mm was used instead.</source>
        <translation>文件注明的单位是 %1（%2 mm）；已改用 1 单位 = %3 mm。</translation>
    </message>
    <message>
        <source>The transparency of colours was not imported.</source>
        <translation>颜色的透明度未导入。</translation>
    </message>
    <message>
        <source>Layers were not imported (number of layers: %1).</source>
        <translation>图层未导入（图层数：%1）。</translation>
    </message>
    <message>
        <source>Dimensions, tolerances and other annotations (PMI) were not imported (number of entries: %1).</source>
        <translation>尺寸、公差和其他标注（PMI）未导入（条目数：%1）。</translation>
    </message>
    <message>
        <source>Assembly %1</source>
        <translation>装配体 %1</translation>
    </message>
    <message>
        <source>1 face has a colour of its own, which is not shown; Burin shows each body in one colour.</source>
        <translation>1 个面有自己的颜色，未予显示；Burin 以一种颜色显示每个实体。</translation>
    </message>
    <message>
        <source>%1 faces have colours of their own, which are not shown; Burin shows each body in one colour.</source>
        <translation>%1 个面有自己的颜色，未予显示；Burin 以一种颜色显示每个实体。</translation>
    </message>
    <message>
        <source>The colour of 1 face was lost when the face was repaired.</source>
        <translation>1 个面在修复时丢失了颜色。</translation>
    </message>
    <message>
        <source>The colours of %1 faces were lost when these faces were repaired.</source>
        <translation>%1 个面在修复时丢失了颜色。</translation>
    </message>
</context>
<context>
    <name>ImportStage</name>
    <message>
        <source>reading the file, %1 of %2 MB</source>
        <translation>正在读取文件，%1 / %2 MB</translation>
    </message>
    <message>
        <source>reading the file of %2 MB (this step cannot be measured)</source>
        <translation>正在读取 %2 MB 的文件（此步骤无法计量进度）</translation>
    </message>
    <message>
        <source>interpreting the file (this step cannot be measured)</source>
        <translation>正在解析文件内容（此步骤无法计量进度）</translation>
    </message>
    <message>
        <source>converting the shapes</source>
        <translation>正在转换形状</translation>
    </message>
    <message>
        <source>checking the solids, %1 of %2</source>
        <translation>正在检查实体，%1 / %2</translation>
    </message>
    <message>
        <source>meshing, body %1 of %2</source>
        <translation>正在划分网格，第 %1 / %2 个实体</translation>
    </message>
</context>
<context>
    <name>ImportUnit</name>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>英尺</translation>
    </message>
    <message>
        <source>yard</source>
        <translation>码</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>MeasureLabels</name>
    <message>
        <source>X %1, Y %2, Z %3</source>
        <translation>X %1, Y %2, Z %3</translation>
    </message>
    <message>
        <source>Plane.</source>
        <translation>平面。</translation>
    </message>
    <message>
        <source>Cylinder, Ø %1.</source>
        <translation>圆柱面，Ø %1。</translation>
    </message>
    <message>
        <source>Cone, Ø %1 there, half angle %2.</source>
        <translation>圆锥面，此处 Ø %1，半角 %2。</translation>
    </message>
    <message>
        <source>Sphere, radius %1.</source>
        <translation>球面，半径 %1。</translation>
    </message>
    <message>
        <source>Torus, radius of the tube %1.</source>
        <translation>圆环面，管半径 %1。</translation>
    </message>
    <message>
        <source>Free-form face.</source>
        <translation>自由曲面。</translation>
    </message>
    <message>
        <source>Position %1.</source>
        <translation>位置 %1。</translation>
    </message>
    <message>
        <source>Wall thickness %1.</source>
        <translation>壁厚 %1。</translation>
    </message>
    <message>
        <source>Parallel, %1 apart.</source>
        <translation>平行，间距 %1。</translation>
    </message>
    <message>
        <source>Angle %1.</source>
        <translation>角度 %1。</translation>
    </message>
    <message>
        <source>Face area %1.</source>
        <translation>面的面积 %1。</translation>
    </message>
    <message>
        <source>Distance between the points: %1 (%2).</source>
        <translation>两点之间的距离：%1（%2）。</translation>
    </message>
    <message>
        <source>Smallest distance between the faces: %1.</source>
        <translation>两面之间的最小距离：%1。</translation>
    </message>
    <message>
        <source>Distance between the nearest corners or circle centres: %1.</source>
        <translation>最近的角点或圆心之间的距离：%1。</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Cylinder, Ø %1</source>
        <translation>圆柱面，Ø %1</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>圆锥面</translation>
    </message>
    <message>
        <source>Sphere, Ø %1</source>
        <translation>球面，Ø %1</translation>
    </message>
    <message>
        <source>Torus, tube Ø %1</source>
        <translation>圆环面，管 Ø %1</translation>
    </message>
    <message>
        <source>Free-form face</source>
        <translation>自由曲面</translation>
    </message>
    <message>
        <source>Cut into the part: %1.</source>
        <translation>切入零件：%1。</translation>
    </message>
    <message>
        <source>Stock left on the part: %1.</source>
        <translation>零件上的残料：%1。</translation>
    </message>
    <message>
        <source>Position %1, within %2.</source>
        <translation>位置 %1，误差不超过 %2。</translation>
    </message>
    <message>
        <source>Depth below the top of the stock: %1.</source>
        <translation>毛坯顶面以下的深度：%1。</translation>
    </message>
    <message>
        <source>Thickness along the line of sight: %1.</source>
        <translation>沿视线的厚度：%1。</translation>
    </message>
    <message>
        <source>Width to the opposite side: %1.</source>
        <translation>到对面的宽度：%1。</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>no details are known</source>
        <translation>没有更多详情</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was cancelled; start it again to finish it.</source>
        <translation>“%1”已取消；重新启动即可完成。</translation>
    </message>
    <message>
        <source>There is not enough memory for &quot;%1&quot;; close other programs or choose larger voxels.</source>
        <translation>内存不足，无法执行“%1”；关闭其他程序或选择更大的体素。</translation>
    </message>
    <message>
        <source>Internal error in &quot;%1&quot; (%2); save your work under another name and report this.</source>
        <translation>“%1”发生内部错误（%2）；将工作另存为其他名称并报告此问题。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not exist; check its name and its folder.</source>
        <translation>“%1”不存在；检查其名称和文件夹。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be written (%2); check the permissions of the file and its folder or choose another location.</source>
        <translation>无法写入“%1”（%2）；检查文件及其文件夹的权限，或选择其他位置。</translation>
    </message>
    <message>
        <source>The disk is full, so &quot;%1&quot; was not written; make room and try again.</source>
        <translation>磁盘已满，“%1”未写入；腾出空间后重试。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty; export or copy it again.</source>
        <translation>“%1”是空的；重新导出或复制该文件。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no format that Burin reads; export it in another one, a model as STEP.</source>
        <translation>“%1”的格式 Burin 无法读取；以其他格式导出，模型用 STEP。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged; use a backup, or export or copy it again.</source>
        <translation>“%1”已损坏；使用备份，或重新导出或复制该文件。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2); use a backup, or export or copy it again.</source>
        <translation>“%1”已损坏（%2）；使用备份，或重新导出或复制该文件。</translation>
    </message>
    <message>
        <source>The value of &quot;%1&quot; can&apos;t be used; allowed is: %2.</source>
        <translation>“%1”的值不可用；允许的值：%2。</translation>
    </message>
    <message>
        <source>The value &quot;%2&quot; of &quot;%1&quot; can&apos;t be used; allowed is: %3.</source>
        <translation>“%1”的值“%2”不可用；允许的值：%3。</translation>
    </message>
    <message>
        <source>No %1 is called &quot;%2&quot;; check the name.</source>
        <translation>没有名为“%2”的%1；检查名称。</translation>
    </message>
    <message>
        <source>No %1 is called &quot;%2&quot;; choose one of these: %3.</source>
        <translation>没有名为“%2”的%1；可选：%3。</translation>
    </message>
    <message>
        <source>This version does not support &quot;%1&quot;; do without it.</source>
        <translation>此版本不支持“%1”；不要使用它。</translation>
    </message>
    <message>
        <source>This version does not support &quot;%1&quot;; use &quot;%2&quot; instead.</source>
        <translation>此版本不支持“%1”；改用“%2”。</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took longer than %2 and was stopped; simplify the model or allow more time.</source>
        <translation>读取“%1”的时间超过 %2，已停止；简化模型或允许更长的时间。</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took more memory than %2 and was stopped; simplify the model or allow more memory.</source>
        <translation>读取“%1”占用的内存超过 %2，已停止；简化模型或允许更多的内存。</translation>
    </message>
    <message>
        <source>The CAD reader failed on &quot;%1&quot; (%2); export the model again, if possible as STEP.</source>
        <translation>CAD 读取程序处理“%1”失败（%2）；重新导出模型，尽可能用 STEP。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains no solid, but: %2; export a closed solid.</source>
        <translation>“%1”不含实体，只有：%2；导出封闭的实体。</translation>
    </message>
    <message>
        <source>The surface of &quot;%1&quot; is open (%2); close it in your CAD program and export it again.</source>
        <translation>“%1”的表面有开口（%2）；在 CAD 程序中将其封闭后重新导出。</translation>
    </message>
    <message>
        <source>Some faces of &quot;%1&quot; can&apos;t be meshed (%2); repair them in your CAD program and export it again.</source>
        <translation>“%1”的部分面无法划分网格（%2）；在 CAD 程序中修复后重新导出。</translation>
    </message>
    <message>
        <source>A stock of %1 is too large for the limit of %2; choose larger voxels or a smaller stock.</source>
        <translation>%1 的毛坯太大，超过限值 %2；选择更大的体素或更小的毛坯。</translation>
    </message>
    <message>
        <source>The memory reserved for the workpiece (%1 bytes) is used up; save, and go on with larger voxels.</source>
        <translation>为工件预留的内存（%1 字节）已用完；先保存，再用更大的体素继续。</translation>
    </message>
    <message>
        <source>The stock&apos;s &quot;%1&quot; can&apos;t be used; allowed is: %2.</source>
        <translation>毛坯的“%1”不可用；允许的值：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be used because of &quot;%2&quot; (%3); correct the file.</source>
        <translation>由于“%2”，“%1”不可用（%3）；更正该文件。</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; was not found; check its cable and its driver.</source>
        <translation>未找到设备“%1”；检查其电缆和驱动程序。</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; reports a fault (%2); its forces are off until you connect it again.</source>
        <translation>设备“%1”报告故障（%2）；在重新连接之前，其力保持关闭。</translation>
    </message>
    <message>
        <source>The trace &quot;%1&quot; can&apos;t be used (%2); correct it or record it again.</source>
        <translation>轨迹“%1”不可用（%2）；更正或重新录制。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a Burin project; choose a file that Burin saved.</source>
        <translation>“%1”不是 Burin 项目；选择由 Burin 保存的文件。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved by a newer Burin (format %2); update Burin to open it.</source>
        <translation>“%1”由更新版本的 Burin 保存（格式 %2）；更新 Burin 后再打开。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another program (%2); close it there first.</source>
        <translation>“%1”已在另一个程序中打开（%2）；先在那里关闭。</translation>
    </message>
    <message>
        <source>The project lacks &quot;%1&quot;; supply it with &quot;%2&quot;.</source>
        <translation>项目缺少“%1”；用“%2”补上。</translation>
    </message>
    <message>
        <source>The disk could not keep up, so the recording ended after %1 samples; use a faster disk.</source>
        <translation>磁盘跟不上，录制在 %1 个采样点后结束；使用更快的磁盘。</translation>
    </message>
    <message>
        <source>The path &quot;%1&quot; contains no move; add a take that cuts, or switch off the edit that drops everything.</source>
        <translation>刀路“%1”没有任何移动；添加有切削的录制，或关闭去掉全部移动的编辑步骤。</translation>
    </message>
    <message>
        <source>No dialect is called &quot;%1&quot;; choose one of these: %2.</source>
        <translation>没有名为“%1”的方言；可选：%2。</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; has interface version %2, but this Burin needs %3; install the one made for it.</source>
        <translation>插件“%1”的接口版本为 %2，而此 Burin 需要 %3；安装与之匹配的插件。</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; can&apos;t be loaded (%2); install it again.</source>
        <translation>无法加载插件“%1”（%2）；重新安装。</translation>
    </message>
    <message>
        <source>The program &quot;%1&quot; can&apos;t be understood at %2 (%3); correct it there.</source>
        <translation>程序“%1”在 %2 处无法识别（%3）；在该处更正。</translation>
    </message>
    <message>
        <source>The machine&apos;s limit of &quot;%1&quot; is exceeded (%2); change the path or choose another machine.</source>
        <translation>超出机床的“%1”极限（%2）；更改刀路或选择其他机床。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; did not pass the check (%2); correct the path and check it again.</source>
        <translation>“%1”未通过检查（%2）；更正刀路后重新检查。</translation>
    </message>
    <message>
        <source>An unknown fault occurred in &quot;%1&quot;; report this.</source>
        <translation>“%1”发生未知故障；报告此问题。</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; was unplugged, so its forces are off; plug it in again to go on.</source>
        <translation>设备“%1”已拔出，其力已关闭；重新插入即可继续。</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; has its forces off for now (%2); they fade in again when that is over.</source>
        <translation>设备“%1”的力暂时关闭（%2）；此情况结束后力会逐渐恢复。</translation>
    </message>
    <message>
        <source>You have no permission to use the device &quot;%1&quot; (%2); install Burin&apos;s udev rule and plug it in again.</source>
        <translation>没有使用设备“%1”的权限（%2）；安装 Burin 的 udev 规则后重新插入设备。</translation>
    </message>
    <message>
        <source>The device &quot;%1&quot; speaks version %2 of its protocol, but this Burin needs %3; update its firmware.</source>
        <translation>设备“%1”的协议版本为 %2，而此 Burin 需要 %3；更新其固件。</translation>
    </message>
    <message>
        <source> (details are in &quot;%1&quot;).</source>
        <translation> （详情见“%1”）。</translation>
    </message>
    <message>
        <source>The motors of &quot;%1&quot; are hot, so its forces go down to half; press less until they have cooled.</source>
        <translation>“%1”的电机过热，力降至一半；在冷却之前轻一点按压。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has to come before &quot;%2&quot; in the list of edits; move it there.</source>
        <translation>在编辑步骤列表中，“%1”必须排在“%2”之前；将其移到那里。</translation>
    </message>
    <message>
        <source>A path can have only one &quot;%1&quot;; delete the other one.</source>
        <translation>一条刀路只能有一个“%1”；删除另一个。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; may lead the tool into the part; put &quot;%2&quot; between it and &quot;%3&quot;.</source>
        <translation>“%1”可能使刀具切入零件；在它与“%3”之间放入“%2”。</translation>
    </message>
    <message>
        <source>There is not enough memory for &quot;%1&quot; (needed and free: %2); close other programs or choose larger voxels.</source>
        <translation>内存不足，无法执行“%1”（需要和可用：%2）；关闭其他程序或选择更大的体素。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; reaches %2 from its origin, and a part may reach %3; choose its unit, or export it again.</source>
        <translation>“%1”从原点伸出达 %2，而零件最多允许 %3；选择其单位，或重新导出。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be read (%2); check that it is the right one and that you have permission to read it.</source>
        <translation>无法读取“%1”（%2）；检查文件是否正确以及是否有读取权限。</translation>
    </message>
    <message>
        <source>No part of the path &quot;%1&quot; can be milled (%2); %3.</source>
        <translation>刀路“%1”没有任何一段可以铣削（%2）；%3。</translation>
    </message>
    <message>
        <source>look at what its edits leave out</source>
        <translation>查看其编辑步骤略去了什么</translation>
    </message>
    <message>
        <source>There is not enough memory for &quot;%1&quot; (needed and free: %2); make a path of fewer or shorter takes, or close other programs.</source>
        <translation>内存不足，无法执行“%1”（需要和可用：%2）；用更少或更短的录制生成刀路，或关闭其他程序。</translation>
    </message>
    <message>
        <source>Reading &quot;%1&quot; took more than %2 of processor time and was stopped; simplify the model or allow more time.</source>
        <translation>读取“%1”占用的处理器时间超过 %2，已停止；简化模型或允许更长的时间。</translation>
    </message>
    <message>
        <source>The parts of &quot;%1&quot; are in other files that are not in its folder (%2); copy them there, or export the assembly as one file.</source>
        <translation>“%1”的零件在其他文件中，而这些文件不在其文件夹内（%2）；将它们复制到那里，或将装配体导出为一个文件。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; reaches out of the stock (%2); enlarge the stock or its margin.</source>
        <translation>“%1”超出毛坯（%2）；加大毛坯或其余量。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has no moves: %2.</source>
        <translation>“%1”没有移动：%2。</translation>
    </message>
    <message>
        <source>The devices of %1 need %2, which is in none of these folders: %3; install it.</source>
        <translation>%1 的设备需要 %2，但以下文件夹中都没有：%3；安装它。</translation>
    </message>
    <message>
        <source>The library &quot;%1&quot; can&apos;t be used (%2); install %3.</source>
        <translation>库“%1”不可用（%2）；安装 %3。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be %2 deep in the stock; move it, or change its sizes.</source>
        <translation>“%1”会进入毛坯 %2；请移动它，或更改其尺寸。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not done, because an undo or redo is still under way; do it again in a moment.</source>
        <translation>未执行“%1”，因为撤销或重做仍在进行；请稍后再试。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can&apos;t be used (%2); correct the file.</source>
        <translation>无法使用“%1”（%2）；请更正该文件。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; moves the tool, but neither vibrates nor pushes, as you have no permission to write to it (%2); install Burin&apos;s udev rule and plug it in again.</source>
        <translation>“%1”能移动刀具，但不振动也不推手，因为没有写入它的权限（%2）；安装 Burin 的 udev 规则后重新插入设备。</translation>
    </message>
    <message>
        <source>The trace &quot;%1&quot; could not be written (%2) and was discarded; milling goes on without it.</source>
        <translation>无法写入轨迹“%1”（%2），已将其丢弃；铣削继续，不再记录轨迹。</translation>
    </message>
    <message>
        <source>The tool can&apos;t be tilted like this (%1); tilt it less, or on another part of the path.</source>
        <translation>刀具不能这样倾斜（%1）；请减小倾斜，或改在刀路的其他部分倾斜。</translation>
    </message>
</context>
<context>
    <name>Migration</name>
    <message>
        <source>Strokes of a take can be undone.</source>
        <translation>录制的笔画可以撤销。</translation>
    </message>
    <message>
        <source>Fixtures, the tool axis and guides are kept.</source>
        <translation>夹具、刀轴和导向会保存。</translation>
    </message>
    <message>
        <source>A job may have several setups.</source>
        <translation>一个作业可以有多个装夹。</translation>
    </message>
    <message>
        <source>Bodies have roles, and the stock a form and layers.</source>
        <translation>实体有角色，毛坯有形状和材料层。</translation>
    </message>
    <message>
        <source>The stock may come from a file.</source>
        <translation>毛坯可以来自文件。</translation>
    </message>
    <message>
        <source>The part can be rotated, and each setup has its own program.</source>
        <translation>零件可以旋转，每个装夹有各自的程序。</translation>
    </message>
    <message>
        <source>Program zero and its work offset can be chosen.</source>
        <translation>可以选择程序零点及其工件偏置。</translation>
    </message>
    <message>
        <source>Paths can be computed, and keep what was asked for.</source>
        <translation>刀路可以计算生成，并保留原来的计算要求。</translation>
    </message>
    <message>
        <source>Takes can be switched off from a moment on, and the workpiece is kept.</source>
        <translation>录制可以从某一时刻起关闭，并保留工件。</translation>
    </message>
    <message>
        <source>Paths can be made of programs, and keep their feeds.</source>
        <translation>刀路可以由程序生成，并保留程序的进给。</translation>
    </message>
    <message>
        <source>Recordings keep the torque that a device gave.</source>
        <translation>录制保存设备输出的扭矩。</translation>
    </message>
    <message>
        <source>Paths of programs keep the coolant of each move.</source>
        <translation>由程序生成的刀路保留每个动作的冷却液。</translation>
    </message>
</context>
<context>
    <name>MillLabels</name>
    <message>
        <source>the workpiece</source>
        <translation>工件</translation>
    </message>
    <message>
        <source>The shank touches the part.</source>
        <translation>刀杆碰到零件。</translation>
    </message>
    <message>
        <source>The holder touches the part.</source>
        <translation>刀柄碰到零件。</translation>
    </message>
    <message>
        <source>The shank touches %1.</source>
        <translation>刀杆碰到%1。</translation>
    </message>
    <message>
        <source>The holder touches %1.</source>
        <translation>刀柄碰到%1。</translation>
    </message>
    <message>
        <source>The machine&apos;s travel ends here.</source>
        <translation>机床行程到此为止。</translation>
    </message>
    <message>
        <source>“%1” holds the tool.</source>
        <translation>“%1”挡住刀具。</translation>
    </message>
    <message>
        <source>The memory for the workpiece is used up, so nothing is cut; save, and go on with larger voxels.</source>
        <translation>工件的内存已用完，因此不再切削；先保存，再用更大的体素继续。</translation>
    </message>
    <message>
        <source>The stylus gives no readings: the tool does not move, and there is no force.</source>
        <translation>触笔没有读数：刀具不动，也没有力。</translation>
    </message>
    <message>
        <source>There is force while button %1 is held.</source>
        <translation>按住按钮 %1 时有力。</translation>
    </message>
    <message>
        <source>Forces fade in, once the tool is clear of the part.</source>
        <translation>刀具离开零件后，力逐渐恢复。</translation>
    </message>
    <message>
        <source>The force is at the device&apos;s limit.</source>
        <translation>力已达到设备的极限。</translation>
    </message>
    <message>
        <source>The motors are hot: forces go down until they have cooled.</source>
        <translation>电机过热：力减小，直到冷却为止。</translation>
    </message>
    <message>
        <source>There is no room to tilt the tool like the hand: its axis does not follow.</source>
        <translation>没有空间让刀具像手一样倾斜：刀轴不跟随。</translation>
    </message>
    <message>
        <source>Shank or holder keep their distance from the stock.</source>
        <translation>刀杆或刀柄与毛坯保持距离。</translation>
    </message>
    <message>
        <source>The stock holds the tool.</source>
        <translation>毛坯挡住刀具。</translation>
    </message>
</context>
<context>
    <name>Omission</name>
    <message>
        <source>The shank would enter material here. Mill the material around it first, or use a tool with longer flutes.</source>
        <translation>刀杆会在此处进入材料。先铣掉周围的材料，或使用刃部更长的刀具。</translation>
    </message>
    <message>
        <source>The holder would enter material here. Mill the material around it first, or use a tool with a longer stick-out.</source>
        <translation>刀柄会在此处进入材料。先铣掉周围的材料，或使用伸出长度更长的刀具。</translation>
    </message>
    <message>
        <source>use a smaller tool or a smaller allowance</source>
        <translation>使用更小的刀具或更小的余量</translation>
    </message>
    <message>
        <source>use a smaller tool, or mill it from another side</source>
        <translation>使用更小的刀具，或从另一侧铣削</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with longer flutes</source>
        <translation>先铣掉周围的材料，或使用刃部更长的刀具</translation>
    </message>
    <message>
        <source>mill the material around it first, or use a tool with a longer stick-out</source>
        <translation>先铣掉周围的材料，或使用伸出长度更长的刀具</translation>
    </message>
    <message>
        <source>There is no room for a ramp or helix down into the material here, and the tool cannot plunge. Begin beside the material, or use a centre-cutting tool.</source>
        <translation>此处没有空间斜坡下刀或螺旋下刀进入材料，而刀具又不能垂直下刀。从材料旁边开始，或使用端刃过中心的刀具。</translation>
    </message>
    <message>
        <source>begin beside the material, or use a centre-cutting tool</source>
        <translation>从材料旁边开始，或使用端刃过中心的刀具</translation>
    </message>
    <message>
        <source>There is no tool motion past the part here. Use a smaller tool or a smaller allowance.</source>
        <translation>此处刀具无法从零件旁通过。使用更小的刀具或更小的余量。</translation>
    </message>
    <message>
        <source>The tool cannot reach this point from above without entering the part. Use a smaller tool, or mill it from another side.</source>
        <translation>刀具从上方到达此点必然会进入零件。使用更小的刀具，或从另一侧铣削。</translation>
    </message>
</context>
<context>
    <name>OmissionLabels</name>
    <message>
        <source>%1 from X %2, Y %3, Z %4: %5</source>
        <translation>%1，自 X %2，Y %3，Z %4 起：%5</translation>
    </message>
    <message>
        <source>%1 left out</source>
        <translation>已略去 %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外%1个</translation>
    </message>
    <message>
        <source>%1 of the path are left out (red in the view).</source>
        <translation>刀路已略去 %1（视图中为红色）。</translation>
    </message>
    <message>
        <source>One hole was not threaded: it is not drilled deep enough, or the part is in the way. Drill it deeper first.</source>
        <translation>有一个孔未铣螺纹：孔钻得不够深，或零件挡住了。请先钻得更深。</translation>
    </message>
    <message>
        <source>%1 holes were not threaded: they are not drilled deep enough, or the part is in the way. Drill them deeper first.</source>
        <translation>有 %1 个孔未铣螺纹：孔钻得不够深，或零件挡住了。请先钻得更深。</translation>
    </message>
    <message>
        <source>One hole is not drilled to full depth: the part is in the way, or the drill is too short.</source>
        <translation>有一个孔未钻到全深：零件挡住了，或钻头太短。</translation>
    </message>
    <message>
        <source>%1 holes are not drilled to full depth: the part is in the way, or the drill is too short.</source>
        <translation>有 %1 个孔未钻到全深：零件挡住了，或钻头太短。</translation>
    </message>
    <message>
        <source>One stud was not threaded: it is not milled to the major diameter, or part or stock around it are in the way of the tool. Mill it first.</source>
        <translation>有一个凸台未铣螺纹：未铣至大径，或其周围的零件或材料挡住了刀具。请先铣削。</translation>
    </message>
    <message>
        <source>%1 studs were not threaded: they are not milled to the major diameter, or part or stock around them are in the way of the tool. Mill them first.</source>
        <translation>有 %1 个凸台未铣螺纹：未铣至大径，或其周围的零件或材料挡住了刀具。请先铣削。</translation>
    </message>
</context>
<context>
    <name>PanelLabels</name>
    <message>
        <source>1 flute</source>
        <translation>1 刃</translation>
    </message>
    <message numerus="yes">
        <source>%n flutes</source>
        <translation>
            <numerusform>%n 刃</numerusform>
        </translation>
    </message>
    <message>
        <source>Specific cutting energy</source>
        <translation>单位切削能</translation>
    </message>
    <message>
        <source>Radial force ratio</source>
        <translation>径向力比</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Surface speed</source>
        <translation>切削速度</translation>
    </message>
    <message>
        <source>Chip load per diameter</source>
        <translation>每齿进给量与直径之比</translation>
    </message>
    <message>
        <source>Plunge feed ratio</source>
        <translation>垂直下刀进给比</translation>
    </message>
    <message>
        <source>Gouge of %1</source>
        <translation>过切 %1</translation>
    </message>
    <message>
        <source>Rapid through %1</source>
        <translation>快速移动穿过 %1</translation>
    </message>
    <message>
        <source>Shank collision, %1</source>
        <translation>刀杆碰撞，%1</translation>
    </message>
    <message>
        <source>Holder collision, %1</source>
        <translation>刀柄碰撞，%1</translation>
    </message>
    <message>
        <source>Spindle off in %1</source>
        <translation>主轴停转时切入 %1</translation>
    </message>
    <message>
        <source>Travel of %1 needed</source>
        <translation>需要行程 %1</translation>
    </message>
    <message>
        <source>Feed of %1 mm/min</source>
        <translation>进给 %1 mm/min</translation>
    </message>
    <message>
        <source>Spindle at %1 rpm</source>
        <translation>主轴转速 %1 rpm</translation>
    </message>
    <message>
        <source>Cuts from an unknown position</source>
        <translation>从未知位置开始切削</translation>
    </message>
    <message>
        <source>Specific cutting force kc1.1</source>
        <translation>单位切削力 kc1.1</translation>
    </message>
    <message>
        <source>Kienzle exponent mc</source>
        <translation>Kienzle 指数 mc</translation>
    </message>
    <message>
        <source>In a fixture by %1</source>
        <translation>进入夹具 %1</translation>
    </message>
    <message>
        <source>Shank passes the stock at %1</source>
        <translation>刀杆经过毛坯，间距 %1</translation>
    </message>
    <message>
        <source>Holder passes the stock at %1</source>
        <translation>刀柄经过毛坯，间距 %1</translation>
    </message>
    <message>
        <source>Shank passes the part at %1</source>
        <translation>刀杆经过零件，间距 %1</translation>
    </message>
    <message>
        <source>Holder passes the part at %1</source>
        <translation>刀柄经过零件，间距 %1</translation>
    </message>
    <message>
        <source>Shank passes a fixture at %1</source>
        <translation>刀杆经过夹具，间距 %1</translation>
    </message>
    <message>
        <source>Holder passes a fixture at %1</source>
        <translation>刀柄经过夹具，间距 %1</translation>
    </message>
    <message>
        <source>The cut takes %1 W, the spindle has %2 W</source>
        <translation>切削需要 %1 W，主轴只有 %2 W</translation>
    </message>
    <message>
        <source>The cut takes %1 N m, the spindle has %2 N m at this speed</source>
        <translation>切削需要 %1 N m，主轴在此转速下只有 %2 N m</translation>
    </message>
    <message>
        <source>The tool bends by %1, the tolerance is %2</source>
        <translation>刀具弯曲 %1，公差为 %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 (and on %n more lines)</source>
        <translation>
            <numerusform>%1（另有 %n 行）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines near there</source>
        <comment>near pass</comment>
        <translation>
            <numerusform>附近有 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>Plunge of %1: the tool does not cut at its centre</source>
        <translation>垂直下刀 %1：刀具端刃不过中心</translation>
    </message>
    <message>
        <source>T%1 is not in the project; nothing after it was checked</source>
        <translation>T%1 不在项目中；其后的内容未检查</translation>
    </message>
    <message>
        <source>Feed move before the tool is loaded</source>
        <translation>装刀之前有进给移动</translation>
    </message>
    <message>
        <source>The length offset of T%1 is not in force</source>
        <translation>T%1 的长度补偿未生效</translation>
    </message>
    <message>
        <source>H%1 is the length offset of another tool</source>
        <translation>H%1 是另一把刀具的长度补偿</translation>
    </message>
    <message>
        <source>Not the project&apos;s work offset</source>
        <translation>不是项目的工件偏置</translation>
    </message>
    <message>
        <source>Blended corners gouge by %1</source>
        <translation>拐角圆滑过渡造成过切 %1</translation>
    </message>
    <message>
        <source>Blended corners leave %1 of stock</source>
        <translation>拐角圆滑过渡留下残料 %1</translation>
    </message>
    <message>
        <source>Leaves %1 on the part, the path leaves %2</source>
        <translation>在零件上留下 %1，刀路留下 %2</translation>
    </message>
    <message>
        <source>Bodies too small for the voxels, not protected: %1</source>
        <translation>因小于体素而未受保护的实体：%1</translation>
    </message>
    <message>
        <source>The tool may break: bending stress of %1 N/mm², limit %2 N/mm²</source>
        <translation>刀具可能折断：弯曲应力 %1 N/mm²，极限 %2 N/mm²</translation>
    </message>
    <message>
        <source>Chip load of %1 per tooth, limit %2</source>
        <translation>每齿进给量 %1，极限 %2</translation>
    </message>
    <message>
        <source>Depth of cut of %1, limit %2</source>
        <translation>切深 %1，极限 %2</translation>
    </message>
    <message>
        <source>Width of cut of %1, limit %2</source>
        <translation>切宽 %1，极限 %2</translation>
    </message>
    <message>
        <source>Spindle rotates anticlockwise; the tool is right-handed</source>
        <translation>主轴逆时针旋转；刀具为右旋</translation>
    </message>
    <message>
        <source>%1, ball end mills</source>
        <translation>%1，球头铣刀</translation>
    </message>
    <message>
        <source>%1, flat end mills</source>
        <translation>%1，平底铣刀</translation>
    </message>
    <message>
        <source>%1, bull-nose end mills</source>
        <translation>%1，圆鼻铣刀</translation>
    </message>
    <message>
        <source>%1, tapered end mills</source>
        <translation>%1，锥度铣刀</translation>
    </message>
    <message>
        <source>%1, tapered ball end mills</source>
        <translation>%1，锥度球头铣刀</translation>
    </message>
    <message>
        <source>%1, drills</source>
        <translation>%1，钻头</translation>
    </message>
    <message>
        <source>%1, chamfer mills</source>
        <translation>%1，倒角刀</translation>
    </message>
    <message>
        <source>%1, lollipop mills</source>
        <translation>%1，球形T刀</translation>
    </message>
    <message>
        <source>%1, form tools</source>
        <translation>%1，成形刀具</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Spindle on in %1</source>
        <translation>主轴旋转时切入 %1</translation>
    </message>
    <message>
        <source>doesn&apos;t turn</source>
        <translation>不旋转</translation>
    </message>
    <message>
        <source>hollow Ø %1 × %2</source>
        <translation>空心 Ø %1 × %2</translation>
    </message>
    <message>
        <source>Rotary axis at %1°, beyond its limits</source>
        <translation>旋转轴位于 %1°，超出极限</translation>
    </message>
</context>
<context>
    <name>Pass</name>
    <message>
        <source>Levels</source>
        <translation>分层</translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>型腔</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>面铣</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>平行</translation>
    </message>
    <message>
        <source>Finishing: parallel rows on the part</source>
        <translation>精加工：零件上的平行走刀</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>放射</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>螺旋</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流线</translation>
    </message>
    <message>
        <source>Finishing: rows on the part that follow a stroke, or are blended from one stroke to the next</source>
        <translation>精加工：零件上沿一条笔画的走刀，或从一条笔画逐渐过渡到下一条的走刀</translation>
    </message>
    <message>
        <source>Waterline</source>
        <translation>等高</translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Roughing: clears the stock level by level, in loops along the part</source>
        <translation>粗加工：沿零件环形走刀，逐层清除毛坯</translation>
    </message>
    <message>
        <source>Clears an area level by level; the cutter stays inside it</source>
        <translation>逐层清除一个区域；铣刀始终在区域之内</translation>
    </message>
    <message>
        <source>Follows the outline of an area, or of the part, level by level</source>
        <translation>逐层沿区域或零件的外形走刀</translation>
    </message>
    <message>
        <source>Clears the stock above the part</source>
        <translation>清除零件上方的毛坯</translation>
    </message>
    <message>
        <source>Finishing: rows on the part from the centre outwards</source>
        <translation>精加工：零件上由中心向外的放射走刀</translation>
    </message>
    <message>
        <source>Finishing: one spiral row on the part from the centre outwards</source>
        <translation>精加工：零件上由中心向外的一条螺旋走刀</translation>
    </message>
    <message>
        <source>Finishing of steep faces: contours of the part at constant Z</source>
        <translation>陡峭面精加工：零件在等 Z 高度上的轮廓</translation>
    </message>
    <message>
        <source>Cuts along lines at a given depth below the top of the stock</source>
        <translation>在毛坯顶面以下给定深度沿线切削</translation>
    </message>
    <message>
        <source>Scallop</source>
        <translation>等残高</translation>
    </message>
    <message>
        <source>Finishing: rows that are evenly far apart on the part, from the border of the area inwards</source>
        <translation>精加工：零件上间距均匀的走刀，从区域边缘向内</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>清根</translation>
    </message>
    <message>
        <source>Follows the concave edges of the part</source>
        <translation>沿零件的凹边走刀</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>残料加工</translation>
    </message>
    <message>
        <source>Finishing only where stock is left: rows on flat faces, contours on steep ones</source>
        <translation>只在有残料处精加工：平坦面用行切，陡峭面用等高轮廓</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>Drills the upright holes of the part that fit the drill, or at given places</source>
        <translation>钻零件上与钻头相配的竖直孔，或在给定位置钻孔</translation>
    </message>
    <message>
        <source>Thread milling</source>
        <translation>铣螺纹</translation>
    </message>
    <message>
        <source>Mills threads in drilled holes that are modelled with the thread&apos;s major diameter, or on studs that are modelled with its minor diameter</source>
        <translation>在已钻好、且按螺纹大径建模的孔内，或在按螺纹小径建模的凸台上铣螺纹</translation>
    </message>
</context>
<context>
    <name>PathQuantity</name>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>Height above zero</source>
        <translation>零点以上高度</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>材料去除率</translation>
    </message>
    <message>
        <source>Cutting force</source>
        <translation>切削力</translation>
    </message>
    <message>
        <source>Deviation from the recording</source>
        <translation>与录制的偏差</translation>
    </message>
</context>
<context>
    <name>PlacementLabels</name>
    <message>
        <source>As in the file.</source>
        <translation>与文件中相同。</translation>
    </message>
    <message>
        <source>Moved by %1.</source>
        <translation>移动%1。</translation>
    </message>
    <message>
        <source>Rotated by %1° about %2, then moved by %3.</source>
        <translation>绕%2旋转%1°，然后移动%3。</translation>
    </message>
</context>
<context>
    <name>ProgramProblem</name>
    <message>
        <source>character is not allowed</source>
        <translation>不允许使用此字符</translation>
    </message>
    <message>
        <source>comment is not closed</source>
        <translation>注释没有结束</translation>
    </message>
    <message>
        <source>comment inside a comment</source>
        <translation>注释中又有注释</translation>
    </message>
    <message>
        <source>the control does not read %</source>
        <translation>数控系统不识别 %</translation>
    </message>
    <message>
        <source>the control does not read this word</source>
        <translation>数控系统不识别此指令字</translation>
    </message>
    <message>
        <source>no other word of the block uses this one</source>
        <translation>程序段中没有其他指令字用到此字</translation>
    </message>
    <message>
        <source>word without a number</source>
        <translation>指令字后没有数字</translation>
    </message>
    <message>
        <source>number is out of range</source>
        <translation>数值超出范围</translation>
    </message>
    <message>
        <source>negative number</source>
        <translation>数值为负</translation>
    </message>
    <message>
        <source>decimal point is missing: the control would take the number for its smallest steps</source>
        <translation>缺少小数点：数控系统会把该数当作最小单位的个数</translation>
    </message>
    <message>
        <source>two words of one modal group</source>
        <translation>同一模态组有两个指令字</translation>
    </message>
    <message>
        <source>the control reads no parameters or expressions</source>
        <translation>数控系统不支持参数和表达式</translation>
    </message>
    <message>
        <source>expression is not complete</source>
        <translation>表达式不完整</translation>
    </message>
    <message>
        <source>expression has no value</source>
        <translation>表达式没有值</translation>
    </message>
    <message>
        <source>there is no such parameter, or it can&apos;t be set</source>
        <translation>没有此参数，或此参数不能赋值</translation>
    </message>
    <message>
        <source>the program has more moves than can be kept (20 million)</source>
        <translation>程序的移动数超过可保存的上限（2000 万）</translation>
    </message>
    <message>
        <source>tool change without a tool</source>
        <translation>换刀未指定刀具</translation>
    </message>
    <message>
        <source>work offset is missing</source>
        <translation>缺少工件偏置</translation>
    </message>
    <message>
        <source>length offset is missing</source>
        <translation>缺少刀具长度补偿</translation>
    </message>
    <message>
        <source>feed together with a change of units</source>
        <translation>进给与单位切换在一起</translation>
    </message>
    <message>
        <source>feed is missing</source>
        <translation>缺少进给速度</translation>
    </message>
    <message>
        <source>each move needs its F while G93 is in force</source>
        <translation>G93 有效时每次移动都需要 F</translation>
    </message>
    <message>
        <source>dwell without its time</source>
        <translation>暂停没有给出时间</translation>
    </message>
    <message>
        <source>dwell and motion in one block</source>
        <translation>暂停与移动在同一程序段</translation>
    </message>
    <message>
        <source>axis word is missing</source>
        <translation>缺少轴字</translation>
    </message>
    <message>
        <source>axis word without a motion in force</source>
        <translation>有轴字，但没有有效的运动指令</translation>
    </message>
    <message>
        <source>G53 needs G0 or G1</source>
        <translation>G53 需要 G0 或 G1</translation>
    </message>
    <message>
        <source>arc without its centre or radius</source>
        <translation>圆弧没有圆心或半径</translation>
    </message>
    <message>
        <source>arc offset without an arc</source>
        <translation>有圆心偏移，但没有圆弧</translation>
    </message>
    <message>
        <source>arc of radius zero</source>
        <translation>圆弧半径为零</translation>
    </message>
    <message>
        <source>radius at the end of the arc differs from the radius at its start</source>
        <translation>圆弧终点处的半径与起点处不一致</translation>
    </message>
    <message>
        <source>radius is too small to reach the end of the arc</source>
        <translation>半径太小，到不了圆弧终点</translation>
    </message>
    <message>
        <source>arc by radius that ends where it begins</source>
        <translation>用半径编程的圆弧终点与起点重合</translation>
    </message>
    <message>
        <source>arc by radius and by centre</source>
        <translation>圆弧同时给出半径和圆心</translation>
    </message>
    <message>
        <source>canned cycle with inverse time feed</source>
        <translation>固定循环使用了反比时间进给</translation>
    </message>
    <message>
        <source>canned cycle without R</source>
        <translation>固定循环没有 R</translation>
    </message>
    <message>
        <source>canned cycle without its depth</source>
        <translation>固定循环没有深度</translation>
    </message>
    <message>
        <source>R of the canned cycle lies below its depth</source>
        <translation>固定循环的 R 低于其深度</translation>
    </message>
    <message>
        <source>canned cycle lacks a word</source>
        <translation>固定循环缺少指令字</translation>
    </message>
    <message>
        <source>Q has to be above 0, and large enough for the depth</source>
        <translation>Q 必须大于 0，并且相对深度足够大</translation>
    </message>
    <message>
        <source>program end is missing</source>
        <translation>缺少程序结束指令</translation>
    </message>
    <message>
        <source>feed is above the machine&apos;s</source>
        <translation>进给速度超过机床上限</translation>
    </message>
    <message>
        <source>spindle speed is beyond the machine&apos;s</source>
        <translation>主轴转速超出机床范围</translation>
    </message>
    <message>
        <source>the program does not state its units</source>
        <translation>程序没有声明单位</translation>
    </message>
    <message>
        <source>feed without a decimal point</source>
        <translation>进给没有小数点</translation>
    </message>
    <message>
        <source>the line is too long for the control</source>
        <translation>行太长，数控系统无法接受</translation>
    </message>
    <message>
        <source>% has to be alone on its line</source>
        <translation>% 必须单独占一行</translation>
    </message>
    <message>
        <source>the control accepts % only in the first line, and after the program only if the first line has one</source>
        <translation>数控系统只接受第一行的 %；只有第一行有 % 时，程序之后才可以有 %</translation>
    </message>
    <message>
        <source>line number has to come first</source>
        <translation>行号必须在最前面</translation>
    </message>
    <message>
        <source>word is repeated</source>
        <translation>指令字重复</translation>
    </message>
    <message>
        <source>number is not an integer</source>
        <translation>数值不是整数</translation>
    </message>
    <message>
        <source>code is not supported</source>
        <translation>不支持此代码</translation>
    </message>
    <message>
        <source>more M words than the control allows in a block</source>
        <translation>M 指令数超过数控系统允许每个程序段的数量</translation>
    </message>
    <message>
        <source>two codes of the block use its axis words</source>
        <translation>程序段中有两个代码使用其轴字</translation>
    </message>
    <message>
        <source>the value of the parameter is unknown</source>
        <translation>参数的值未知</translation>
    </message>
    <message>
        <source>cutter radius compensation is not supported: program the centre of the tool</source>
        <translation>不支持刀具半径补偿：按刀具中心编程</translation>
    </message>
    <message>
        <source>subprograms and flow control are not supported</source>
        <translation>不支持子程序和流程控制</translation>
    </message>
    <message>
        <source>feed per revolution with the spindle stopped</source>
        <translation>每转进给，但主轴停止</translation>
    </message>
    <message>
        <source>the start position is unknown</source>
        <translation>起始位置未知</translation>
    </message>
    <message>
        <source>arc offset perpendicular to the arc&apos;s plane</source>
        <translation>圆心偏移垂直于圆弧平面</translation>
    </message>
    <message>
        <source>number of turns has to be an integer above 0</source>
        <translation>圈数必须是大于 0 的整数</translation>
    </message>
    <message>
        <source>canned cycle with the spindle stopped, or rotating in the wrong direction</source>
        <translation>固定循环中主轴停止或转向错误</translation>
    </message>
    <message>
        <source>number of repeats has to be an integer from 1 to 10000</source>
        <translation>重复次数必须是 1 到 10000 的整数</translation>
    </message>
    <message>
        <source>whether arc centres are absolute is a setting of this control: state G91.1</source>
        <translation>圆心是否为绝对坐标取决于此数控系统的设置：写明 G91.1</translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>Do you want to save them?</source>
        <translation>要保存吗？</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the project, then go on.</source>
        <translation>保存项目，然后继续。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Go on; the changes are lost.</source>
        <translation>继续；更改将丢失。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change nothing.</source>
        <translation>不作任何更改。</translation>
    </message>
    <message>
        <source>Burin</source>
        <translation>Burin</translation>
    </message>
    <message>
        <source>About Burin</source>
        <translation>关于 Burin</translation>
    </message>
    <message>
        <source>Burin %1</source>
        <translation>Burin %1</translation>
    </message>
    <message>
        <source>Milling tool paths authored by hand.

The method follows Chen and Yang, “Haptic rendering based on spatial run-length encoding”, Robotics and Computer-Integrated Manufacturing 20 (2004) 237–246.

Free software under the Apache License 2.0. Made with Qt, VTK, OpenCASCADE, oneTBB, SQLite and Zstandard.</source>
        <translation>手工创作铣削刀路。

方法依据 Chen 和 Yang 的论文“Haptic rendering based on spatial run-length encoding”，Robotics and Computer-Integrated Manufacturing 20 (2004) 237–246。

采用 Apache License 2.0 的自由软件。使用 Qt、VTK、OpenCASCADE、oneTBB、SQLite 和 Zstandard 制作。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Override the check</source>
        <translation>忽略检查结果</translation>
    </message>
    <message>
        <source>Its check found 1 problem that can damage a tool, the part or the machine.</source>
        <translation>检查发现 1 个问题，可能损坏刀具、零件或机床。</translation>
    </message>
    <message numerus="yes">
        <source>Its check found %n problems that can damage a tool, the part or the machine.</source>
        <translation>
            <numerusform>检查发现 %n 个问题，可能损坏刀具、零件或机床。</numerusform>
        </translation>
    </message>
    <message>
        <source>Your reason. It goes into the program&apos;s header together with the findings.</source>
        <translation>你的理由。它将与问题一起写入程序头。</translation>
    </message>
    <message>
        <source>Export a program that was refused?</source>
        <translation>导出被拒绝的程序？</translation>
    </message>
    <message>
        <source>Close this window.</source>
        <translation>关闭此窗口。</translation>
    </message>
</context>
<context>
    <name>Resource</name>
    <message>
        <source>Aluminium 6061-T6</source>
        <translation>铝合金 6061-T6</translation>
    </message>
    <message>
        <source>Machinable wax</source>
        <translation>机加工蜡</translation>
    </message>
    <message>
        <source>Tooling board (polyurethane)</source>
        <translation>代木（聚氨酯）</translation>
    </message>
    <message>
        <source>Ball-end mill 1 mm</source>
        <translation>球头铣刀 1 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 10 mm</source>
        <translation>球头铣刀 10 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 3 mm</source>
        <translation>球头铣刀 3 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 6 mm</source>
        <translation>球头铣刀 6 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 10 mm, corner radius 2 mm</source>
        <translation>圆鼻铣刀 10 mm，圆角半径 2 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 16 mm, corner radius 3 mm</source>
        <translation>圆鼻铣刀 16 mm，圆角半径 3 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 6 mm, corner radius 1 mm</source>
        <translation>圆鼻铣刀 6 mm，圆角半径 1 mm</translation>
    </message>
    <message>
        <source>End mill 10 mm</source>
        <translation>平底铣刀 10 mm</translation>
    </message>
    <message>
        <source>End mill 3 mm</source>
        <translation>平底铣刀 3 mm</translation>
    </message>
    <message>
        <source>End mill 6 mm</source>
        <translation>平底铣刀 6 mm</translation>
    </message>
    <message>
        <source>Chamfer mill 6 mm, 90°</source>
        <translation>倒角刀 6 mm，90°</translation>
    </message>
    <message>
        <source>Drill 5 mm</source>
        <translation>钻头 5 mm</translation>
    </message>
    <message>
        <source>Lollipop mill 6 mm</source>
        <translation>球形T刀 6 mm</translation>
    </message>
    <message>
        <source>Taper ball mill 1 mm, 5° a side</source>
        <translation>锥度球头铣刀 1 mm，单边 5°</translation>
    </message>
    <message>
        <source>Ball-screw router with grblHAL (typical)</source>
        <translation>滚珠丝杠雕铣机，grblHAL（典型）</translation>
    </message>
    <message>
        <source>Desktop router with GRBL 1.1 (Shapeoko 3 settings)</source>
        <translation>桌面雕铣机，GRBL 1.1（Shapeoko 3 设置）</translation>
    </message>
    <message>
        <source>Hobby mill with Mach3 (typical)</source>
        <translation>业余铣床，Mach3（典型）</translation>
    </message>
    <message>
        <source>Three-axis mill with LinuxCNC (example)</source>
        <translation>三轴铣床，LinuxCNC（示例）</translation>
    </message>
    <message>
        <source>Vertical machining centre with a Fanuc control (typical)</source>
        <translation>立式加工中心，Fanuc 数控系统（典型）</translation>
    </message>
    <message>
        <source>Vertical machining centre with a Haas control (typical)</source>
        <translation>立式加工中心，Haas 数控系统（典型）</translation>
    </message>
    <message>
        <source>Haas mill</source>
        <translation>Haas 铣床</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Acrylic (PMMA)</source>
        <translation>亚克力（PMMA）</translation>
    </message>
    <message>
        <source>Aluminium 2007 (free-cutting)</source>
        <translation>铝合金 2007（易切削）</translation>
    </message>
    <message>
        <source>Aluminium 7075-T6</source>
        <translation>铝合金 7075-T6</translation>
    </message>
    <message>
        <source>Beech</source>
        <translation>山毛榉木</translation>
    </message>
    <message>
        <source>Brass CuZn39Pb3</source>
        <translation>黄铜 CuZn39Pb3</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>中密度纤维板（MDF）</translation>
    </message>
    <message>
        <source>Oak</source>
        <translation>橡木</translation>
    </message>
    <message>
        <source>POM (acetal)</source>
        <translation>POM（聚甲醛）</translation>
    </message>
    <message>
        <source>Polyurethane foam</source>
        <translation>聚氨酯泡沫</translation>
    </message>
    <message>
        <source>Stainless steel 304 (1.4301)</source>
        <translation>不锈钢 304（1.4301）</translation>
    </message>
    <message>
        <source>Steel 1045 (C45)</source>
        <translation>钢 1045（C45）</translation>
    </message>
    <message>
        <source>Steel S235JR</source>
        <translation>钢 S235JR</translation>
    </message>
    <message>
        <source>Titanium Ti-6Al-4V</source>
        <translation>钛合金 Ti-6Al-4V</translation>
    </message>
    <message>
        <source>ER11 collet in a 52 mm spindle</source>
        <translation>ER11 弹簧夹头，52 mm 主轴</translation>
    </message>
    <message>
        <source>ER16 collet chuck</source>
        <translation>ER16 弹簧夹头刀柄</translation>
    </message>
    <message>
        <source>ER20 collet chuck</source>
        <translation>ER20 弹簧夹头刀柄</translation>
    </message>
    <message>
        <source>ER20 collet in an 80 mm spindle</source>
        <translation>ER20 弹簧夹头，80 mm 主轴</translation>
    </message>
    <message>
        <source>ER25 collet chuck, BT30</source>
        <translation>ER25 弹簧夹头刀柄，BT30</translation>
    </message>
    <message>
        <source>ER32 collet chuck, BT40</source>
        <translation>ER32 弹簧夹头刀柄，BT40</translation>
    </message>
    <message>
        <source>Hydraulic chuck 12 mm, BT40</source>
        <translation>液压刀柄 12 mm，BT40</translation>
    </message>
    <message>
        <source>Shrink chuck 6 mm, HSK-A63</source>
        <translation>热缩刀柄 6 mm，HSK-A63</translation>
    </message>
    <message>
        <source>End mill 1 mm</source>
        <translation>平底铣刀 1 mm</translation>
    </message>
    <message>
        <source>End mill 1.5 mm</source>
        <translation>平底铣刀 1.5 mm</translation>
    </message>
    <message>
        <source>End mill 2 mm</source>
        <translation>平底铣刀 2 mm</translation>
    </message>
    <message>
        <source>End mill 2.5 mm</source>
        <translation>平底铣刀 2.5 mm</translation>
    </message>
    <message>
        <source>End mill 4 mm</source>
        <translation>平底铣刀 4 mm</translation>
    </message>
    <message>
        <source>End mill 5 mm</source>
        <translation>平底铣刀 5 mm</translation>
    </message>
    <message>
        <source>End mill 8 mm</source>
        <translation>平底铣刀 8 mm</translation>
    </message>
    <message>
        <source>End mill 12 mm</source>
        <translation>平底铣刀 12 mm</translation>
    </message>
    <message>
        <source>End mill 16 mm</source>
        <translation>平底铣刀 16 mm</translation>
    </message>
    <message>
        <source>End mill 20 mm</source>
        <translation>平底铣刀 20 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 1.5 mm</source>
        <translation>球头铣刀 1.5 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 2 mm</source>
        <translation>球头铣刀 2 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 4 mm</source>
        <translation>球头铣刀 4 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 5 mm</source>
        <translation>球头铣刀 5 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 8 mm</source>
        <translation>球头铣刀 8 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 12 mm</source>
        <translation>球头铣刀 12 mm</translation>
    </message>
    <message>
        <source>Ball-end mill 16 mm</source>
        <translation>球头铣刀 16 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 3 mm, corner radius 0.5 mm</source>
        <translation>圆鼻铣刀 3 mm，圆角半径 0.5 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 4 mm, corner radius 0.5 mm</source>
        <translation>圆鼻铣刀 4 mm，圆角半径 0.5 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 6 mm, corner radius 0.5 mm</source>
        <translation>圆鼻铣刀 6 mm，圆角半径 0.5 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 8 mm, corner radius 1 mm</source>
        <translation>圆鼻铣刀 8 mm，圆角半径 1 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 8 mm, corner radius 2 mm</source>
        <translation>圆鼻铣刀 8 mm，圆角半径 2 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 10 mm, corner radius 1 mm</source>
        <translation>圆鼻铣刀 10 mm，圆角半径 1 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 12 mm, corner radius 1 mm</source>
        <translation>圆鼻铣刀 12 mm，圆角半径 1 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 12 mm, corner radius 3 mm</source>
        <translation>圆鼻铣刀 12 mm，圆角半径 3 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 16 mm, corner radius 2 mm</source>
        <translation>圆鼻铣刀 16 mm，圆角半径 2 mm</translation>
    </message>
    <message>
        <source>Bull-nose end mill 20 mm, corner radius 3 mm</source>
        <translation>圆鼻铣刀 20 mm，圆角半径 3 mm</translation>
    </message>
    <message>
        <source>Drill 1 mm</source>
        <translation>钻头 1 mm</translation>
    </message>
    <message>
        <source>Drill 1.5 mm</source>
        <translation>钻头 1.5 mm</translation>
    </message>
    <message>
        <source>Drill 2 mm</source>
        <translation>钻头 2 mm</translation>
    </message>
    <message>
        <source>Drill 2.5 mm</source>
        <translation>钻头 2.5 mm</translation>
    </message>
    <message>
        <source>Drill 3 mm</source>
        <translation>钻头 3 mm</translation>
    </message>
    <message>
        <source>Drill 3.3 mm</source>
        <translation>钻头 3.3 mm</translation>
    </message>
    <message>
        <source>Drill 4 mm</source>
        <translation>钻头 4 mm</translation>
    </message>
    <message>
        <source>Drill 4.2 mm</source>
        <translation>钻头 4.2 mm</translation>
    </message>
    <message>
        <source>Drill 6 mm</source>
        <translation>钻头 6 mm</translation>
    </message>
    <message>
        <source>Drill 6.8 mm</source>
        <translation>钻头 6.8 mm</translation>
    </message>
    <message>
        <source>Drill 8 mm</source>
        <translation>钻头 8 mm</translation>
    </message>
    <message>
        <source>Drill 8.5 mm</source>
        <translation>钻头 8.5 mm</translation>
    </message>
    <message>
        <source>Drill 10 mm</source>
        <translation>钻头 10 mm</translation>
    </message>
    <message>
        <source>Drill 10.2 mm</source>
        <translation>钻头 10.2 mm</translation>
    </message>
    <message>
        <source>Drill 12 mm</source>
        <translation>钻头 12 mm</translation>
    </message>
    <message>
        <source>Chamfer mill 8 mm, 90°</source>
        <translation>倒角刀 8 mm，90°</translation>
    </message>
    <message>
        <source>Chamfer mill 10 mm, 90°</source>
        <translation>倒角刀 10 mm，90°</translation>
    </message>
    <message>
        <source>Chamfer mill 12 mm, 90°</source>
        <translation>倒角刀 12 mm，90°</translation>
    </message>
    <message>
        <source>Chamfer mill 10 mm, 60°</source>
        <translation>倒角刀 10 mm，60°</translation>
    </message>
    <message>
        <source>Engraving cutter 6 mm, 30°, tip 0.2 mm</source>
        <translation>雕刻刀 6 mm，30°，刀尖 0.2 mm</translation>
    </message>
    <message>
        <source>Taper ball mill 2 mm, 3° a side</source>
        <translation>锥度球头铣刀 2 mm，单边 3°</translation>
    </message>
    <message>
        <source>Taper ball mill 0.5 mm, 10° a side</source>
        <translation>锥度球头铣刀 0.5 mm，单边 10°</translation>
    </message>
    <message>
        <source>Tapered end mill 2 mm, 3° a side</source>
        <translation>锥度铣刀 2 mm，单边 3°</translation>
    </message>
    <message>
        <source>Tapered end mill 2 mm, 5° a side</source>
        <translation>锥度铣刀 2 mm，单边 5°</translation>
    </message>
    <message>
        <source>Lollipop mill 4 mm</source>
        <translation>球形T刀 4 mm</translation>
    </message>
    <message>
        <source>Lollipop mill 8 mm</source>
        <translation>球形T刀 8 mm</translation>
    </message>
    <message>
        <source>Lollipop mill 10 mm</source>
        <translation>球形T刀 10 mm</translation>
    </message>
    <message>
        <source>Thread mill M3 × 0.5</source>
        <translation>螺纹铣刀 M3 × 0.5</translation>
    </message>
    <message>
        <source>Thread mill M4 × 0.7</source>
        <translation>螺纹铣刀 M4 × 0.7</translation>
    </message>
    <message>
        <source>Thread mill M5 × 0.8</source>
        <translation>螺纹铣刀 M5 × 0.8</translation>
    </message>
    <message>
        <source>Thread mill M6 × 1</source>
        <translation>螺纹铣刀 M6 × 1</translation>
    </message>
    <message>
        <source>Thread mill M8 × 1.25</source>
        <translation>螺纹铣刀 M8 × 1.25</translation>
    </message>
    <message>
        <source>Thread mill M10 × 1.5</source>
        <translation>螺纹铣刀 M10 × 1.5</translation>
    </message>
    <message>
        <source>Thread mill M12 × 1.75</source>
        <translation>螺纹铣刀 M12 × 1.75</translation>
    </message>
    <message>
        <source>Five-axis mill with LinuxCNC, tilting rotary table (example)</source>
        <translation>LinuxCNC 五轴铣床，倾斜旋转工作台（示例）</translation>
    </message>
</context>
<context>
    <name>RestartDialog</name>
    <message>
        <source>The first cut is line %1 of the interrupted program; all lines before it count as done.</source>
        <translation>第一次切削是中断程序的第%1行；此前各行都视为已完成。</translation>
    </message>
    <message>
        <source>The last %1 of the path before that line are cut again.</source>
        <translation>该行之前最后%1的刀路会重新切削一遍。</translation>
    </message>
    <message>
        <source>Tool %1%2 at %3. Measure the new tool first.</source>
        <translation>刀具%1%2，%3。先测量新刀具。</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>第%1行：%2</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>以及另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Passed its check on the stock that is left.</source>
        <translation>在剩余毛坯上通过了检查。</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Restart at line %1</source>
        <translation>从第%1行重新开始</translation>
    </message>
    <message>
        <source>The rest of the program</source>
        <translation>程序的剩余部分</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write nothing; the program stays as it is (Esc)</source>
        <translation>不写入任何内容；程序保持原样 (Esc)</translation>
    </message>
    <message>
        <source>Write the rest as a program of its own; the program of the project stays as it is</source>
        <translation>将剩余部分写成独立的程序；项目中的程序保持原样</translation>
    </message>
    <message>
        <source>The tool comes down from above to X %1, Y %2, Z %3.</source>
        <translation>刀具从上方下降到 X %1，Y %2，Z %3。</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>程序：%1</translation>
    </message>
    <message>
        <source>Did not pass its check on the stock that is left (1 finding). Choose an earlier line, or override the check with a reason.</source>
        <translation>在剩余毛坯上未通过检查（1 个问题）。选择更靠前的行，或说明理由后忽略检查结果。</translation>
    </message>
    <message numerus="yes">
        <source>Did not pass its check on the stock that is left (%n findings). Choose an earlier line, or override the check with a reason.</source>
        <translation>
            <numerusform>在剩余毛坯上未通过检查（%n 个问题）。选择更靠前的行，或说明理由后忽略检查结果。</numerusform>
        </translation>
    </message>
    <message>
        <source>Override the check…</source>
        <translation>忽略检查结果…</translation>
    </message>
    <message>
        <source>Write the rest nevertheless; its header shows your reason</source>
        <translation>仍然写出剩余部分；程序头会注明你的理由</translation>
    </message>
</context>
<context>
    <name>ScoreLabels</name>
    <message>
        <source>the same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>▲ better by %1</source>
        <translation>▲ 优于参考 %1</translation>
    </message>
    <message>
        <source>▼ worse by %1</source>
        <translation>▼ 差于参考 %1</translation>
    </message>
    <message>
        <source>▲ better by %1 (%2)</source>
        <translation>▲ 优于参考 %1（%2）</translation>
    </message>
    <message>
        <source>▼ worse by %1 (%2)</source>
        <translation>▼ 差于参考 %1（%2）</translation>
    </message>
</context>
<context>
    <name>ScoreValue</name>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Time of the whole recording</source>
        <translation>整段录制的时间</translation>
    </message>
    <message>
        <source>Milling time</source>
        <translation>铣削时间</translation>
    </message>
    <message>
        <source>Time with the spindle turning</source>
        <translation>主轴转动的时间</translation>
    </message>
    <message>
        <source>Tries to gouge</source>
        <translation>过切尝试次数</translation>
    </message>
    <message>
        <source>Largest push</source>
        <translation>最大压入量</translation>
    </message>
    <message>
        <source>How far the hand pushed into the part at most</source>
        <translation>手压入零件的最大深度</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>平滑度</translation>
    </message>
    <message>
        <source>Mean force</source>
        <translation>平均力</translation>
    </message>
    <message>
        <source>Mean cutting force while material is removed</source>
        <translation>去除材料时的平均切削力</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>Largest cutting force</source>
        <translation>最大切削力</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>去除量</translation>
    </message>
    <message>
        <source>Volume that the take removed when it was recorded</source>
        <translation>该录制在录制时去除的体积</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>材料去除率</translation>
    </message>
    <message>
        <source>Volume removed, divided by the milling time</source>
        <translation>去除的体积除以铣削时间</translation>
    </message>
    <message>
        <source>Stock left, mean</source>
        <translation>残料，平均</translation>
    </message>
    <message>
        <source>Stock on the part after the take, on average where its tool can reach</source>
        <translation>该录制之后零件上的残料，在其刀具可达处取平均</translation>
    </message>
    <message>
        <source>Stock left, largest</source>
        <translation>残料，最大</translation>
    </message>
    <message>
        <source>The thickest stock there; 20 mm means 20 mm or more</source>
        <translation>该处最厚的残料；20 mm 表示 20 mm 或更多</translation>
    </message>
    <message>
        <source>Spectral arc length (SPARC) of the tip&apos;s speed while milling, without pauses: one smooth movement has -1.41, a lower value means more tremor and interruptions</source>
        <translation>铣削时（不含停顿）刀尖速度的频谱弧长（SPARC）：一次平滑的运动为 -1.41，数值越低表示抖动和中断越多</translation>
    </message>
    <message>
        <source>How often the hand pushed the tool more than 0.1 mm against the part, which stopped it</source>
        <translation>手将刀具向零件压入超过 0.1 mm 并被零件挡住的次数</translation>
    </message>
</context>
<context>
    <name>SetupDialog</name>
    <message>
        <source>rotated by 180° about X</source>
        <translation>绕 X 旋转 180°</translation>
    </message>
    <message>
        <source>rotated by 180° about Y</source>
        <translation>绕 Y 旋转 180°</translation>
    </message>
    <message>
        <source>rotated by 90° about X</source>
        <translation>绕 X 旋转 90°</translation>
    </message>
    <message>
        <source>rotated by -90° about X</source>
        <translation>绕 X 旋转 -90°</translation>
    </message>
    <message>
        <source>rotated by 90° about Y</source>
        <translation>绕 Y 旋转 90°</translation>
    </message>
    <message>
        <source>rotated by -90° about Y</source>
        <translation>绕 Y 旋转 -90°</translation>
    </message>
    <message>
        <source>not rotated</source>
        <translation>不旋转</translation>
    </message>
    <message>
        <source>Add a setup</source>
        <translation>添加装夹</translation>
    </message>
    <message>
        <source>Name of the setup, shown in lists and in the file name of its program</source>
        <translation>装夹的名称，显示在列表中和程序的文件名里</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Rotation about the centre of the part, relative to this setup. You can change it later</source>
        <translation>相对此装夹绕零件中心的旋转。以后可以更改</translation>
    </message>
    <message>
        <source>The part is</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>the workpiece of this setup</source>
        <translation>此装夹的工件</translation>
    </message>
    <message>
        <source>new stock with the same margins</source>
        <translation>余量相同的新毛坯</translation>
    </message>
    <message>
        <source>The workpiece after the checked program of this setup. Without one: after its recordings</source>
        <translation>按此装夹的已检查程序加工后的工件。没有程序时：按其录制加工后的工件</translation>
    </message>
    <message>
        <source>Its stock is</source>
        <translation>毛坯为</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add the setup and switch to it</source>
        <translation>添加装夹并切换到该装夹</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>不作任何更改</translation>
    </message>
</context>
<context>
    <name>Subject</name>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>embedded stock</source>
        <translation>嵌入零件的毛坯</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>a tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>body</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>方言</translation>
    </message>
    <message>
        <source>edit</source>
        <translation>编辑步骤</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>path</source>
        <translation>刀路</translation>
    </message>
    <message>
        <source>stylus</source>
        <translation>触笔</translation>
    </message>
    <message>
        <source>take</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>boundary field of a tool</source>
        <translation>刀具的边界场</translation>
    </message>
    <message>
        <source>exact distances</source>
        <translation>精确距离</translation>
    </message>
    <message>
        <source>milling</source>
        <translation>铣削</translation>
    </message>
    <message>
        <source>replaying takes</source>
        <translation>重放录制</translation>
    </message>
    <message>
        <source>verification</source>
        <translation>校验</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>voxelisation</source>
        <translation>体素化</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>tilted tool axis</source>
        <translation>倾斜的刀轴</translation>
    </message>
    <message>
        <source>a program with a tool change</source>
        <translation>带换刀的程序</translation>
    </message>
    <message>
        <source>another process</source>
        <translation>另一个进程</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>进程%1</translation>
    </message>
    <message>
        <source>command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>benchmark</source>
        <translation>基准测试</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>a restart of a program that sets its own zero</source>
        <translation>自设零点的程序的重新开始</translation>
    </message>
    <message>
        <source>a restart over a change of the path mode (G61, G64)</source>
        <translation>跨越路径模式 (G61, G64) 切换的重新开始</translation>
    </message>
    <message>
        <source>a restart over a change of the work offset</source>
        <translation>跨越工件偏置切换的重新开始</translation>
    </message>
    <message>
        <source>restart line</source>
        <translation>重新开始行</translation>
    </message>
    <message>
        <source>plunge feed</source>
        <translation>下刀进给</translation>
    </message>
    <message>
        <source>maximum feed</source>
        <translation>最大进给</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>maximum spindle speed</source>
        <translation>最高主轴转速</translation>
    </message>
    <message>
        <source>X travel</source>
        <translation>X 行程</translation>
    </message>
    <message>
        <source>Y travel</source>
        <translation>Y 行程</translation>
    </message>
    <message>
        <source>Z travel</source>
        <translation>Z 行程</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>interrupted program</source>
        <translation>中断的程序</translation>
    </message>
    <message>
        <source>MODEL</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>FORCES</source>
        <translation>测力数据</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>paths</source>
        <translation>刀路</translation>
    </message>
    <message>
        <source>tool number</source>
        <translation>刀具号</translation>
    </message>
    <message>
        <source>voxel</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>装夹</translation>
    </message>
    <message>
        <source>the virtual operator with this kind of tool</source>
        <translation>使用此类刀具的虚拟操作员</translation>
    </message>
    <message>
        <source>tilt of the tool axis</source>
        <translation>刀轴倾斜</translation>
    </message>
    <message>
        <source>axes other than X, Y and Z</source>
        <translation>X、Y、Z 以外的轴</translation>
    </message>
    <message>
        <source>insert</source>
        <translation>嵌件</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>材料层</translation>
    </message>
    <message>
        <source>checked program</source>
        <translation>已检查的程序</translation>
    </message>
    <message>
        <source>generated moves</source>
        <translation>生成的移动</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>走刀</translation>
    </message>
    <message>
        <source>face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>this pass with this kind of tool</source>
        <translation>使用此类刀具的这种走刀</translation>
    </message>
    <message>
        <source>test force</source>
        <translation>测试力</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>scoring a take</source>
        <translation>录制评分</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>kind of fixture</source>
        <translation>夹具类型</translation>
    </message>
    <message>
        <source>size of a fixture</source>
        <translation>夹具尺寸</translation>
    </message>
    <message>
        <source>library</source>
        <translation>刀具库</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>螺纹</translation>
    </message>
    <message>
        <source>a computed pass with a tool that doesn&apos;t turn</source>
        <translation>用不旋转的刀具计算走刀</translation>
    </message>
    <message>
        <source>the virtual operator with a tool that doesn&apos;t turn</source>
        <translation>使用不旋转刀具的虚拟操作员</translation>
    </message>
    <message>
        <source>a program for a tool that doesn&apos;t turn</source>
        <translation>用于不旋转刀具的程序</translation>
    </message>
    <message>
        <source>a tilted axis of a tool that doesn&apos;t turn</source>
        <translation>不旋转刀具的倾斜轴线</translation>
    </message>
    <message>
        <source>gain of axis</source>
        <translation>轴的增益</translation>
    </message>
    <message>
        <source>dead zone of axis</source>
        <translation>轴的死区</translation>
    </message>
    <message>
        <source>rest of axis</source>
        <translation>轴的静止位置</translation>
    </message>
    <message>
        <source>buttons</source>
        <translation>按钮</translation>
    </message>
    <message>
        <source>a path of a program for a tool that doesn&apos;t turn</source>
        <translation>由程序为不旋转刀具生成的刀路</translation>
    </message>
    <message>
        <source>a tilted axis of a tool with a hollow tip</source>
        <translation>空心刀尖刀具的倾斜轴线</translation>
    </message>
    <message>
        <source>test strength</source>
        <translation>测试强度</translation>
    </message>
    <message>
        <source>change of a fixture</source>
        <translation>夹具的更改</translation>
    </message>
    <message>
        <source>tool axis</source>
        <translation>刀轴</translation>
    </message>
    <message>
        <source>a tilted tool on %1</source>
        <translation>在“%1”上倾斜刀具</translation>
    </message>
    <message>
        <source>a restart of a program that tilts the tool</source>
        <translation>从中间重新启动使刀具倾斜的程序</translation>
    </message>
</context>
<context>
    <name>Take</name>
    <message>
        <source>free hand</source>
        <translation>徒手</translation>
    </message>
    <message>
        <source>roughing</source>
        <translation>粗加工</translation>
    </message>
    <message>
        <source>finishing</source>
        <translation>精加工</translation>
    </message>
    <message>
        <source>scribble</source>
        <translation>涂画</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>hostile hand</source>
        <translation>粗暴的手</translation>
    </message>
    <message>
        <source>take %1</source>
        <translation>录制%1</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1（副本）</translation>
    </message>
</context>
<context>
    <name>TakeMenu</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Switch &amp;on</source>
        <translation>启用(&amp;O)</translation>
    </message>
    <message>
        <source>Switch the &amp;stroke off</source>
        <translation>停用笔画(&amp;S)</translation>
    </message>
    <message>
        <source>The workpiece and the paths are made without it, until it is switched on again.</source>
        <translation>生成工件和刀路时不计入它，直到重新启用。</translation>
    </message>
    <message>
        <source>Switch the &amp;take off</source>
        <translation>停用录制(&amp;T)</translation>
    </message>
    <message>
        <source>Switch &amp;all of the take on</source>
        <translation>启用整个录制(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>重命名(&amp;R)…</translation>
    </message>
    <message>
        <source>Rename the take</source>
        <translation>重命名录制</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>The workpiece is milled again without it.</source>
        <translation>工件将不含它重新铣削。</translation>
    </message>
    <message>
        <source>Rename the marker</source>
        <translation>重命名标记</translation>
    </message>
    <message>
        <source>Delete the marker.</source>
        <translation>删除标记。</translation>
    </message>
    <message>
        <source>Add a marker</source>
        <translation>添加标记</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>标记%1</translation>
    </message>
    <message>
        <source>It counts again, milled on top of the current workpiece.</source>
        <translation>它重新计入，在当前工件上追加铣削。</translation>
    </message>
    <message>
        <source>Rename the take.</source>
        <translation>重命名录制。</translation>
    </message>
    <message>
        <source>Rename the marker.</source>
        <translation>重命名标记。</translation>
    </message>
    <message>
        <source>State how well the take was milled, and compare it with a reference.</source>
        <translation>显示该录制铣削得如何，并与参考录制比较。</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>上移(&amp;U)</translation>
    </message>
    <message>
        <source>Replay it before the take above it.</source>
        <translation>在其上一段录制之前重放。</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>下移(&amp;W)</translation>
    </message>
    <message>
        <source>Replay it after the take below it.</source>
        <translation>在其下一段录制之后重放。</translation>
    </message>
    <message>
        <source>Dupli&amp;cate</source>
        <translation>复制录制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy it with its strokes and what is switched off. No path mills the copy until its menu adds it.</source>
        <translation>复制录制，连同其笔画和停用部分。在副本的菜单中加入刀路之前，没有刀路铣削该副本。</translation>
    </message>
    <message>
        <source>Take out of the &amp;path</source>
        <translation>从刀路中移出(&amp;P)</translation>
    </message>
    <message>
        <source>Mill in the &amp;path</source>
        <translation>在刀路中铣削(&amp;P)</translation>
    </message>
    <message>
        <source>The path of its tool mills this copy no longer.</source>
        <translation>其刀具的刀路不再铣削此副本。</translation>
    </message>
    <message>
        <source>The path of its tool mills this copy as well, after its other takes.</source>
        <translation>其刀具的刀路也铣削此副本，排在其他录制之后。</translation>
    </message>
    <message>
        <source>Scor&amp;e…</source>
        <translation>评分(&amp;E)…</translation>
    </message>
</context>
<context>
    <name>TimelineCurveLabels</name>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>材料去除率</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>Engagement</source>
        <translation>吃刀量</translation>
    </message>
    <message>
        <source>Push-back</source>
        <translation>反推力</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
</context>
<context>
    <name>ViewCube</name>
    <message>
        <source>TOP</source>
        <translation>上</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>下</translation>
    </message>
    <message>
        <source>FRONT</source>
        <translation>前</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>后</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>左</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>右</translation>
    </message>
</context>
<context>
    <name>burin::ActionStates</name>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做(&amp;R)：%1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
</context>
<context>
    <name>burin::AllowancePanel</name>
    <message>
        <source>Allowance</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Stock to leave</source>
        <translation>预留余量</translation>
    </message>
    <message>
        <source>The allowance can&apos;t be changed while recording.</source>
        <translation>录制时不能更改余量。</translation>
    </message>
    <message>
        <source>Distance of the boundary from the part</source>
        <translation>边界到零件的距离</translation>
    </message>
    <message>
        <source>Smallest distance between the tool and the part. Leave some stock while roughing; with 0 the cutter may touch the part and finish it.</source>
        <translation>刀具与零件之间的最小距离。粗加工时留一些余量；为 0 时铣刀可以接触零件，将其加工到位。</translation>
    </message>
</context>
<context>
    <name>burin::AreaCard</name>
    <message>
        <source>Clear the area: the next pass goes over the whole part</source>
        <translation>清除区域：下一次走刀覆盖整个零件</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>画笔</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Brush diameter</source>
        <translation>画笔直径</translation>
    </message>
    <message>
        <source>Ctrl+wheel in the view changes it, too</source>
        <translation>在视图中用 Ctrl+滚轮也可更改</translation>
    </message>
    <message>
        <source>Area of the next pass: %1</source>
        <translation>下一次走刀的区域：%1</translation>
    </message>
    <message>
        <source>Area of the next pass: whole part</source>
        <translation>下一次走刀的区域：整个零件</translation>
    </message>
    <message>
        <source>Paint on the part; Shift erases</source>
        <translation>在零件上涂画；按住 Shift 擦除</translation>
    </message>
    <message>
        <source>Draw round an area; Shift erases</source>
        <translation>圈画一个区域；按住 Shift 擦除</translation>
    </message>
    <message>
        <source>Click faces of the part; Shift removes</source>
        <translation>单击零件的面；按住 Shift 移除</translation>
    </message>
    <message>
        <source>There is no part to paint on yet.</source>
        <translation>还没有可涂画的零件。</translation>
    </message>
    <message>
        <source>Paint the area of the next pass on the part with a brush; Shift erases</source>
        <translation>用画笔在零件上涂出下一次走刀的区域；按住 Shift 擦除</translation>
    </message>
    <message>
        <source>Draw round the area of the next pass; Shift erases</source>
        <translation>圈画下一次走刀的区域；按住 Shift 擦除</translation>
    </message>
    <message>
        <source>Click faces of the part for the next pass; Shift removes them</source>
        <translation>单击零件的面用于下一次走刀；按住 Shift 移除</translation>
    </message>
</context>
<context>
    <name>burin::AreaController</name>
    <message>
        <source>painting an area</source>
        <translation>涂画区域</translation>
    </message>
    <message>
        <source>erasing from an area</source>
        <translation>擦除区域</translation>
    </message>
    <message>
        <source>clearing the area</source>
        <translation>清除区域</translation>
    </message>
</context>
<context>
    <name>burin::AreaPainter</name>
    <message>
        <source>Esc: discard this stroke</source>
        <translation>Esc：放弃这一笔</translation>
    </message>
    <message>
        <source>Esc: stop painting</source>
        <translation>Esc：停止涂画</translation>
    </message>
</context>
<context>
    <name>burin::AxisDialog</name>
    <message>
        <source>Axes and buttons: %1</source>
        <translation>轴和按钮：%1</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Stop calibrating</source>
        <translation>停止标定</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Usual assignment</source>
        <translation>常用分配</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>The device is not connected.</source>
        <translation>设备未连接。</translation>
    </message>
    <message>
        <source>Leave the device at rest for two seconds.</source>
        <translation>请让设备静止两秒。</translation>
    </message>
    <message>
        <source>Move every axis to both of its ends, then press Finish.</source>
        <translation>将每个轴移动到两端，然后按“完成”。</translation>
    </message>
    <message>
        <source>Connecting the device…</source>
        <translation>正在连接设备…</translation>
    </message>
    <message>
        <source>Move the device: each bar shows its axis, a dot the pressed buttons.</source>
        <translation>移动设备：每个条显示其轴，圆点表示按下的按钮。</translation>
    </message>
    <message>
        <source>Axes that were not moved before the measurement keep their rest and dead zone (%1); move every axis once first, then calibrate again.</source>
        <translation>测量前未移动过的轴保留其静止位置和死区（%1）；请先将每个轴移动一次，然后重新校准。</translation>
    </message>
    <message>
        <source>The rest position is being measured.</source>
        <translation>正在测量静止位置。</translation>
    </message>
    <message>
        <source>Press this when every axis has been at both of its ends</source>
        <translation>每个轴都到过两端后按下</translation>
    </message>
    <message>
        <source>Measure rest position, noise and ends of the axes: two seconds at rest, then move them</source>
        <translation>测量轴的静止位置、噪声和两端：先静止两秒，再移动</translation>
    </message>
</context>
<context>
    <name>burin::AxisRows</name>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>驱动</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>死区</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>按钮</translation>
    </message>
    <message>
        <source>What this axis moves, as seen from the user</source>
        <translation>此轴驱动的运动（从用户方向看）</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>The axis moves the other way</source>
        <translation>轴向相反方向运动</translation>
    </message>
    <message>
        <source>Share of the full motion at full deflection; more than 1 reaches it earlier</source>
        <translation>满偏转时占全部运动的比例；大于 1 则更早达到</translation>
    </message>
    <message>
        <source>Share of the deflection from rest that has no effect</source>
        <translation>从静止位置起不起作用的偏转比例</translation>
    </message>
    <message>
        <source>Lower end, rest and upper end of the axis, % of its nominal range</source>
        <translation>轴的下端、静止位置和上端，占标称范围的 %</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>按钮 %1</translation>
    </message>
    <message>
        <source>What this button does while the device mills</source>
        <translation>设备铣削时此按钮的作用</translation>
    </message>
    <message>
        <source>%1 to %3 %, rest %2 %</source>
        <translation>%1 至 %3 %，静止 %2 %</translation>
    </message>
</context>
<context>
    <name>burin::AxisTuner</name>
    <message>
        <source>Reading the axes of %1</source>
        <translation>正在读取 %1 的轴</translation>
    </message>
</context>
<context>
    <name>burin::BoundsPanel</name>
    <message>
        <source>Fixtures and limits</source>
        <translation>夹具与限制</translation>
    </message>
    <message>
        <source>Whether it keeps the tool out. If the tool is inside, it waits until the tool is clear</source>
        <translation>是否阻止刀具进入。如果刀具已在其中，则等刀具离开后才生效</translation>
    </message>
    <message>
        <source>Machine&apos;s travel</source>
        <translation>机床行程</translation>
    </message>
</context>
<context>
    <name>burin::CalibrationDialog</name>
    <message>
        <source>%1: %2 of %3 records, noise %4 N tangential, %5 N radial</source>
        <translation>%1：%3条记录中的%2条，切向噪声%4 N，径向噪声%5 N</translation>
    </message>
    <message>
        <source>K = %1 J/mm³ at chips of %2 mm</source>
        <translation>K = %1 J/mm³，切屑厚度 %2 mm</translation>
    </message>
    <message>
        <source>Kr = %1</source>
        <translation>Kr = %1</translation>
    </message>
    <message>
        <source>kc1.1 = %1 N/mm², mc = %2</source>
        <translation>kc1.1 = %1 N/mm², mc = %2</translation>
    </message>
    <message>
        <source>Kte = %1 N/mm, Kre = %2 N/mm</source>
        <translation>Kte = %1 N/mm, Kre = %2 N/mm</translation>
    </message>
    <message>
        <source>Line %1 left out: %2</source>
        <translation>第%1行已略过：%2</translation>
    </message>
    <message>
        <source>Calibrate materials</source>
        <translation>标定材料</translation>
    </message>
    <message>
        <source>No other material</source>
        <translation>不参照其他材料</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Measured forces</source>
        <translation>实测力</translation>
    </message>
    <message>
        <source>CSV with a row for each cut; `burin calibrate --help` lists the columns</source>
        <translation>CSV，每次切削一行；各列见 `burin calibrate --help`</translation>
    </message>
    <message>
        <source>K and the force of the edge</source>
        <translation>K 与刃口力</translation>
    </message>
    <message>
        <source>K alone</source>
        <translation>仅 K</translation>
    </message>
    <message>
        <source>Kienzle: K falls with the chip</source>
        <translation>Kienzle：K 随切屑增厚而减小</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>切削力规律</translation>
    </message>
    <message>
        <source>How the force depends on the thickness of the chip</source>
        <translation>力与切屑厚度的关系</translation>
    </message>
    <message>
        <source>Rotating teeth</source>
        <translation>旋转刀齿</translation>
    </message>
    <message>
        <source>Feed and axis</source>
        <translation>进给方向与轴向</translation>
    </message>
    <message>
        <source>Forces resolved for</source>
        <translation>力的分解方式</translation>
    </message>
    <message>
        <source>Rotating teeth: forces of a dynamometer. Feed and axis: the force that the hand feels against its motion</source>
        <translation>旋转刀齿：测力仪测得的力。进给方向与轴向：手感受到的与运动方向相反的力</translation>
    </message>
    <message>
        <source>New materials are like</source>
        <translation>新材料参照</translation>
    </message>
    <message>
        <source>Whose other values a material takes over that is not in the library</source>
        <translation>库中没有的材料，其余数值取自此材料</translation>
    </message>
    <message>
        <source>On: the forces act on the workpiece, as a dynamometer below it measures. Off: on the tool</source>
        <translation>开：力作用于工件，如工件下方的测力仪所测。关：力作用于刀具</translation>
    </message>
    <message>
        <source>Forces on the workpiece</source>
        <translation>力作用于工件</translation>
    </message>
    <message>
        <source>Keep in the library</source>
        <translation>保存到库中</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose a file of measured forces first.</source>
        <translation>先选择实测力的文件。</translation>
    </message>
    <message>
        <source>There is nothing to keep yet.</source>
        <translation>还没有可保存的内容。</translation>
    </message>
    <message>
        <source>In brackets: the interval that holds the true value in 95 % of such measurements.</source>
        <translation>括号内：在 95 % 的此类测量中包含真值的区间。</translation>
    </message>
    <message>
        <source>Keep these materials as your own; Undo takes each back</source>
        <translation>将这些材料保存为自己的材料；可用撤销逐个取消</translation>
    </message>
    <message>
        <source>Result of the calibration</source>
        <translation>标定结果</translation>
    </message>
</context>
<context>
    <name>burin::Coach</name>
    <message>
        <source>Key: %1</source>
        <translation>按键：%1</translation>
    </message>
    <message>
        <source>Wait until Burin has done this.</source>
        <translation>请等待 Burin 完成。</translation>
    </message>
    <message>
        <source>The check refused the program: its findings say why. Delete your edit or mill anew, then post again.</source>
        <translation>检查未通过该程序，原因见所列问题。删除所加的编辑步骤或重新铣削，然后再次后处理。</translation>
    </message>
    <message>
        <source>Your first job is done</source>
        <translation>第一个作业已完成</translation>
    </message>
    <message>
        <source>You milled by hand, and the machine can repeat it. The help has more on every step.</source>
        <translation>手工铣削已完成，机床可以重复它。每一步的更多说明见帮助。</translation>
    </message>
    <message>
        <source>You have done this step.</source>
        <translation>此步已完成。</translation>
    </message>
</context>
<context>
    <name>burin::CoachPanel</name>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Show the previous step</source>
        <translation>显示上一步</translation>
    </message>
    <message>
        <source>First job</source>
        <translation>第一个作业</translation>
    </message>
    <message>
        <source>First job: step %1 of %2</source>
        <translation>第一个作业：第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Skip this step</source>
        <translation>跳过此步</translation>
    </message>
    <message>
        <source>Go on to the step that is not done yet</source>
        <translation>转到尚未完成的步骤</translation>
    </message>
    <message>
        <source>Go on without this step</source>
        <translation>不做此步，继续</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Close the first job (Esc)</source>
        <translation>关闭第一个作业（Esc）</translation>
    </message>
    <message>
        <source>End the first job; the project stays (Esc)</source>
        <translation>结束第一个作业；项目保留（Esc）</translation>
    </message>
</context>
<context>
    <name>burin::ComparisonDialog</name>
    <message>
        <source>Compare paths</source>
        <translation>比较刀路</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>This path in another version, or another path of the setup</source>
        <translation>此刀路的另一版本，或该装夹的另一条刀路</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Cuts farther apart than this are marked red in the view</source>
        <translation>相距超过此值的切削移动在视图中标为红色</translation>
    </message>
    <message>
        <source>This path</source>
        <translation>此刀路</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>另一条</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>切削移动</translation>
    </message>
    <message>
        <source>Plunges</source>
        <translation>垂直下刀</translation>
    </message>
    <message>
        <source>Rapids and retracts</source>
        <translation>快速移动和抬刀</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Time at feed</source>
        <translation>进给时间</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>平均偏差</translation>
    </message>
    <message>
        <source>Farther than the tolerance</source>
        <translation>超出公差</translation>
    </message>
    <message>
        <source>The other path is drawn thin, in turquoise. Deviations are those of the cuts of either path from the cuts of the other.</source>
        <translation>另一条刀路以青绿色细线显示。偏差是每条刀路的切削移动与另一条的切削移动之间的偏差。</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>最大偏差</translation>
    </message>
    <message>
        <source>Largest deviation of the other path</source>
        <translation>另一条刀路的最大偏差</translation>
    </message>
    <message>
        <source>Largest deviation of this path</source>
        <translation>此刀路的最大偏差</translation>
    </message>
    <message>
        <source>There is no deviation to show</source>
        <translation>没有可显示的偏差</translation>
    </message>
    <message>
        <source>Show the point in the view</source>
        <translation>在视图中显示该点</translation>
    </message>
</context>
<context>
    <name>burin::ComparisonPresenter</name>
    <message>
        <source>The paths are being compared.</source>
        <translation>正在比较刀路。</translation>
    </message>
    <message>
        <source>Waits until both paths are up to date.</source>
        <translation>等待两条刀路都更新完毕。</translation>
    </message>
    <message>
        <source>One of the paths has no cuts: there is no deviation.</source>
        <translation>其中一条刀路没有切削移动：没有偏差。</translation>
    </message>
    <message>
        <source>itself without edits, as recorded or computed</source>
        <translation>不含编辑步骤的自身，即录制或计算时的样子</translation>
    </message>
    <message>
        <source>itself without edit %1: %2</source>
        <translation>去掉编辑步骤 %1 的自身：%2</translation>
    </message>
    <message>
        <source>path %1, %2: %3</source>
        <translation>刀路 %1，%2：%3</translation>
    </message>
</context>
<context>
    <name>burin::DeviationCard</name>
    <message>
        <source>Show the deviation</source>
        <translation>显示偏差</translation>
    </message>
    <message>
        <source>Bands of deviation and their shares of the part</source>
        <translation>偏差分段及其在零件上的占比</translation>
    </message>
    <message>
        <source>Gouge deeper than %1</source>
        <translation>过切深于%1</translation>
    </message>
    <message>
        <source>Within %1</source>
        <translation>%1以内</translation>
    </message>
    <message>
        <source>More is left</source>
        <translation>残料更多</translation>
    </message>
    <message>
        <source>Out of the tool&apos;s reach</source>
        <translation>刀具够不到</translation>
    </message>
    <message>
        <source>Here: %1 too deep</source>
        <translation>此处：过深%1</translation>
    </message>
    <message>
        <source>Here: %1 left</source>
        <translation>此处：残留%1</translation>
    </message>
    <message>
        <source>out of the tool&apos;s reach</source>
        <translation>刀具够不到</translation>
    </message>
    <message>
        <source>Colours the part by the excess stock that the program leaves, or by the depth of its gouges</source>
        <translation>按程序留下的残料或过切深度为零件着色</translation>
    </message>
    <message>
        <source>Move the pointer over the part to read the deviation.</source>
        <translation>将指针移到零件上可读取偏差。</translation>
    </message>
    <message>
        <source>Faces…</source>
        <translation>面…</translation>
    </message>
    <message>
        <source>Something has changed since the check; post and check it again</source>
        <translation>检查之后有改动；须重新后处理并检查</translation>
    </message>
    <message>
        <source>Lists the faces of the part with gouges and stock left on each</source>
        <translation>列出零件的面，以及各面上的过切和残料</translation>
    </message>
</context>
<context>
    <name>burin::DeviationLegend</name>
    <message>
        <source>Scale of the deviation</source>
        <translation>偏差色标</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>过深</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <translation>公差内</translation>
    </message>
    <message>
        <source>too much left</source>
        <translation>残料过多</translation>
    </message>
    <message>
        <source>not measured, or out of the tool&apos;s reach</source>
        <translation>未测量，或刀具够不到</translation>
    </message>
</context>
<context>
    <name>burin::DeviceDialog</name>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Test force</source>
        <translation>测试力</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Mouse and keyboard, always there</source>
        <translation>鼠标和键盘，始终可用</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>检测结果</translation>
    </message>
    <message>
        <source>Not plugged in</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>library missing</source>
        <translation>缺少驱动库</translation>
    </message>
    <message>
        <source>Stop the test</source>
        <translation>停止测试</translation>
    </message>
    <message>
        <source>Read the device while you move it: rate, position, buttons</source>
        <translation>移动设备时读取其数据：频率、位置、按钮</translation>
    </message>
    <message>
        <source>Cutting force felt</source>
        <translation>切削力手感</translation>
    </message>
    <message>
        <source>Friction felt</source>
        <translation>摩擦手感</translation>
    </message>
    <message>
        <source>Mill with this device</source>
        <translation>用此设备铣削</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>已选择</translation>
    </message>
    <message>
        <source>Select a device that is plugged in.</source>
        <translation>选择一个已连接的设备。</translation>
    </message>
    <message>
        <source>Select a device or the mouse.</source>
        <translation>选择一个设备或鼠标。</translation>
    </message>
    <message>
        <source>Use this device the next time you start milling</source>
        <translation>下次开始铣削时使用此设备</translation>
    </message>
    <message>
        <source>Move the device through its whole workspace and press every button.</source>
        <translation>在整个工作空间内移动设备，并按下每个按钮。</translation>
    </message>
    <message>
        <source>The device pushes up with this force while you hold its first button. It fades in over one second and is limited to a fifth of the maximum force. 0: motors off</source>
        <translation>按住设备的第一个按钮时，设备以此力向上推。力在一秒内逐渐增大，并限制为最大力的五分之一。0：电机关闭</translation>
    </message>
    <message>
        <source>1: a reference cut in the hardest material gives 60 % of the maximum force. 0: only the part is felt, not the cutting</source>
        <translation>1：在最硬的材料中作基准切削时为最大力的 60 %。0：只能感觉到零件，感觉不到切削</translation>
    </message>
    <message>
        <source>Friction coefficient where the tool slides without cutting</source>
        <translation>刀具滑动而不切削时的摩擦系数</translation>
    </message>
    <message>
        <source>Stop milling first.</source>
        <translation>先停止铣削。</translation>
    </message>
    <message>
        <source>moves the view</source>
        <translation>移动视图</translation>
    </message>
    <message>
        <source>Stop moving the view</source>
        <translation>停止移动视图</translation>
    </message>
    <message>
        <source>Move the view with this device</source>
        <translation>用此设备移动视图</translation>
    </message>
    <message>
        <source>Select a 3D mouse, gamepad or joystick.</source>
        <translation>选择一个 3D 鼠标、游戏手柄或摇杆。</translation>
    </message>
    <message>
        <source>Pan, zoom and rotate the view with this device, beside the stylus. Its first button fits the view. While it moves the tool, the view stays</source>
        <translation>在使用触笔的同时，用此设备平移、缩放和旋转视图。其第一个按钮使视图适合窗口。用它移动刀具时，视图不动</translation>
    </message>
    <message>
        <source>Axes and buttons…</source>
        <translation>轴和按钮…</translation>
    </message>
    <message>
        <source>Stop the test first.</source>
        <translation>请先停止测试。</translation>
    </message>
    <message>
        <source>What the axes and buttons of a gamepad, joystick, tablet or 3D mouse do, and their calibration</source>
        <translation>手柄、操纵杆、数位板或 3D 鼠标的轴和按钮的作用，以及标定</translation>
    </message>
    <message>
        <source>Strength of the assist</source>
        <translation>辅助强度</translation>
    </message>
    <message>
        <source>Ceiling of a gamepad&apos;s vibration or a joystick&apos;s force, as a share of its strongest effect. Vibration: the strong motor shows how deep you push, the weak one how hard the tool cuts. A joystick pushes only while a button is held, in the test the first one. 0: off</source>
        <translation>手柄振动或摇杆力的上限，为其最强效果的比例。振动：强马达表示压入多深，弱马达表示切削多重。摇杆只在按住按钮时推手，测试时为第一个按钮。0：关闭</translation>
    </message>
    <message>
        <source>Distance from the stock</source>
        <translation>与毛坯的距离</translation>
    </message>
    <message>
        <source>Distance that shank and holder keep from the stock, counted from the centres of its voxels, with every stylus, while “Keep from the stock” is on in the menu Mill. A change restarts milling.</source>
        <translation>铣削菜单中的“与毛坯保持距离”打开时，刀杆和刀柄与毛坯保持的距离，从毛坯体素的中心算起，对所有触笔有效。更改后铣削会重新开始。</translation>
    </message>
</context>
<context>
    <name>burin::DeviceGains</name>
    <message>
        <source>Maximum stiffness</source>
        <translation>最大刚度</translation>
    </message>
    <message>
        <source>The part never feels stiffer than this, whatever the device allows. 0: as stiff as it allows</source>
        <translation>无论设备允许多大，工件的手感都不会比这更硬。0：设备允许多硬就多硬</translation>
    </message>
    <message>
        <source>Friction of the handle</source>
        <translation>手柄摩擦力</translation>
    </message>
    <message>
        <source>Force with which a spring balance just moves the handle while the motors are off. It absorbs the steps of the encoders, and limits the suggested stiffness. 0: not measured</source>
        <translation>电机关闭时，弹簧秤刚好拉动手柄所需的力。它吸收编码器的步进，并限制建议刚度。0：未测量</translation>
    </message>
    <message>
        <source>Use the suggested gains</source>
        <translation>使用建议的增益</translation>
    </message>
    <message>
        <source>Previous gains</source>
        <translation>恢复之前的增益</translation>
    </message>
    <message>
        <source>Test a device with motors first: its rate and latency are measured for this.</source>
        <translation>请先测试一台带电机的设备：为此需要测量其速率和延迟。</translation>
    </message>
    <message>
        <source>The suggested gains are in use.</source>
        <translation>建议的增益已在使用。</translation>
    </message>
    <message>
        <source>Use the stiffness and damping that the test suggests for this device, the next time you mill. “Previous gains” takes it back.</source>
        <translation>下次铣削时使用测试为该设备建议的刚度和阻尼。“恢复之前的增益”可撤回。</translation>
    </message>
    <message>
        <source>The gains of this device were not changed.</source>
        <translation>该设备的增益没有更改过。</translation>
    </message>
    <message>
        <source>Use the stiffness and damping from before the last change again</source>
        <translation>重新使用上次更改之前的刚度和阻尼</translation>
    </message>
</context>
<context>
    <name>burin::DeviceTester</name>
    <message>
        <source>Looking for devices</source>
        <translation>正在查找设备</translation>
    </message>
    <message>
        <source>Testing %1</source>
        <translation>正在测试%1</translation>
    </message>
</context>
<context>
    <name>burin::DocumentController</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
</context>
<context>
    <name>burin::DocumentFlow</name>
    <message>
        <source>The file was moved, renamed or deleted, or its drive is not connected.</source>
        <translation>文件已被移动、重命名或删除，或其所在的驱动器未连接。</translation>
    </message>
    <message>
        <source>Remove “%1” from the list of recent files?</source>
        <translation>从最近文件列表中移除“%1”？</translation>
    </message>
    <message>
        <source>Remove it from the list</source>
        <translation>从列表中移除</translation>
    </message>
    <message>
        <source>workpiece</source>
        <translation>工件</translation>
    </message>
    <message>
        <source>“%1” is an NC program: open its project or embed its part first, then open the program again.</source>
        <translation>“%1”是 NC 程序：先打开其项目或嵌入其零件，然后再打开该程序。</translation>
    </message>
    <message>
        <source>“%1” becomes a path of a job: open its project or embed its part first, then open it again.</source>
        <translation>“%1”将成为作业的刀路：先打开其项目或嵌入其零件，然后再打开它。</translation>
    </message>
</context>
<context>
    <name>burin::EditCard</name>
    <message>
        <source>Switch this edit on or off</source>
        <translation>启用或停用此编辑步骤</translation>
    </message>
    <message>
        <source>%1 → %2 points</source>
        <translation>%1 → %2 个点</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>误差%1</translation>
    </message>
    <message>
        <source>Apply this edit earlier</source>
        <translation>提前应用此编辑步骤</translation>
    </message>
    <message>
        <source>Apply this edit later</source>
        <translation>推后应用此编辑步骤</translation>
    </message>
    <message>
        <source>Delete this edit</source>
        <translation>删除此编辑步骤</translation>
    </message>
    <message>
        <source>Update this edit to its current version; its result changes</source>
        <translation>将此编辑步骤更新到当前版本；其结果会改变</translation>
    </message>
    <message>
        <source>Show in the view where the error is the largest</source>
        <translation>在视图中显示误差最大的位置</translation>
    </message>
</context>
<context>
    <name>burin::EditFieldEditor</name>
    <message>
        <source>Draw it in the view; Esc leaves it as it is</source>
        <translation>在视图中绘制；按 Esc 保持原样</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>绘制%1</translation>
    </message>
</context>
<context>
    <name>burin::EmbeddingFindings</name>
    <message>
        <source>Findings of embedding</source>
        <translation>嵌入时的问题</translation>
    </message>
    <message>
        <source>And %1 more, which “burin embed” lists.</source>
        <translation>还有%1个，用“burin embed”可列出。</translation>
    </message>
</context>
<context>
    <name>burin::ExcessPresenter</name>
    <message>
        <source>%1 left on the part</source>
        <translation>零件上残料%1</translation>
    </message>
</context>
<context>
    <name>burin::FaceController</name>
    <message>
        <source>Inspecting the faces</source>
        <translation>正在检查各面</translation>
    </message>
</context>
<context>
    <name>burin::FaceDialog</name>
    <message>
        <source>Faces of the part</source>
        <translation>零件的面</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop inspecting the faces</source>
        <translation>停止检查各面</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the table in its order, in mm, to paste it into a spreadsheet (Ctrl+C)</source>
        <translation>按当前顺序以 mm 复制表格，以便粘贴到电子表格 (Ctrl+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write the table in its order, in mm, as a CSV file</source>
        <translation>按当前顺序以 mm 把表格写成 CSV 文件</translation>
    </message>
    <message>
        <source>What the program leaves on each face of the part.</source>
        <translation>程序在零件各面上留下的结果。</translation>
    </message>
    <message>
        <source>Faces: %1. With gouges: %2. With too much stock: %3. Select a face to see its worst point.</source>
        <translation>面：%1。有过切的：%2。残料过多的：%3。选择一个面即可看到其最差的点。</translation>
    </message>
    <message>
        <source>Inspecting the faces</source>
        <translation>正在检查各面</translation>
    </message>
</context>
<context>
    <name>burin::FacePicker</name>
    <message>
        <source>Esc: cancel the selection of a face</source>
        <translation>Esc：取消选择面</translation>
    </message>
</context>
<context>
    <name>burin::FacePresenter</name>
    <message>
        <source>There is no checked program, or something has changed since; post and check it again.</source>
        <translation>没有检查过的程序，或检查之后有改动；须重新后处理并检查。</translation>
    </message>
    <message>
        <source>Face %1: %2 too deep</source>
        <translation>面 %1：过深 %2</translation>
    </message>
    <message>
        <source>Face %1: %2 left</source>
        <translation>面 %1：残留 %2</translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation>面 %1</translation>
    </message>
    <message>
        <source>Cancelled; open the table again to inspect the faces.</source>
        <translation>已取消；重新打开表格即可检查各面。</translation>
    </message>
</context>
<context>
    <name>burin::FaceTableModel</name>
    <message>
        <source>Too small for the voxels: no point of this face was looked at; use smaller voxels</source>
        <translation>对体素来说太小：这个面上没有取到点；可改用更小的体素</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Number in the order of the part&apos;s file</source>
        <translation>按零件文件中的顺序编号</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Shape of the face, with its diameter</source>
        <translation>面的形状及其直径</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Area of the whole face</source>
        <translation>整个面的面积</translation>
    </message>
    <message>
        <source>Worst gouge</source>
        <translation>最深过切</translation>
    </message>
    <message>
        <source>Deepest cut into the part on this face</source>
        <translation>这个面上切入零件最深之处</translation>
    </message>
    <message>
        <source>Most left</source>
        <translation>最大残料</translation>
    </message>
    <message>
        <source>Most stock beyond the allowance, where a tool of the program could reach it</source>
        <translation>超出余量的最大残料（程序中的刀具能够到达之处）</translation>
    </message>
    <message>
        <source>In tolerance</source>
        <translation>公差内</translation>
    </message>
    <message>
        <source>Share of the face that is within tolerance</source>
        <translation>这个面在公差内的比例</translation>
    </message>
    <message>
        <source>Gouged</source>
        <translation>过切</translation>
    </message>
    <message>
        <source>Too much left</source>
        <translation>残料过多</translation>
    </message>
    <message>
        <source>Share of the face with more stock than the tolerance allows</source>
        <translation>残料超过公差的比例</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>刀具够不到</translation>
    </message>
    <message>
        <source>Share of the face with stock that no tool of the program can reach</source>
        <translation>程序中没有刀具能到达其残料的比例</translation>
    </message>
    <message>
        <source>Share of the face&apos;s points where a gouge deeper than the tolerance is marked. Each position of the tool marks the point that is nearest to its deepest one, so more of the face may be cut into</source>
        <translation>这个面上标有超差过切的点所占的比例。刀具的每个位置只标出离其最深处最近的点，所以实际过切的部分可能更大</translation>
    </message>
</context>
<context>
    <name>burin::FixtureDialog</name>
    <message>
        <source>Click the stock or the table in the view, or drag, to place it. In the view, the arrow keys move it by 1 mm (Shift: 0.1 mm, Ctrl: 10 mm), R rotates it by 15° (Shift: 90°), Enter accepts it.</source>
        <translation>在视图中单击毛坯或工作台，或拖动，即可放置。在视图中，方向键每次移动 1 mm（Shift：0.1 mm，Ctrl：10 mm），R 旋转 15°（Shift：90°），回车键确认。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Kind of fixture of the library</source>
        <translation>夹具库中夹具的类型</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Origin of the fixture, from program zero</source>
        <translation>夹具的原点，相对于程序零点</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>About Z, through its origin</source>
        <translation>绕通过其原点的 Z 轴</translation>
    </message>
    <message>
        <source>Rotate it about Z</source>
        <translation>绕 Z 旋转</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>不作任何更改</translation>
    </message>
    <message>
        <source>Change a fixture</source>
        <translation>更改夹具</translation>
    </message>
    <message>
        <source>Add a fixture</source>
        <translation>添加夹具</translation>
    </message>
    <message>
        <source>%1 X, Y, Z, in %2</source>
        <translation>%1 X、Y、Z，单位 %2</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Change the fixture of the setup</source>
        <translation>更改此装夹的夹具</translation>
    </message>
    <message>
        <source>Add the fixture to the setup</source>
        <translation>把夹具添加到此装夹</translation>
    </message>
    <message>
        <source>Sizes of the fixture</source>
        <translation>夹具的尺寸</translation>
    </message>
    <message>
        <source>There is no stock where the fixture clamps.</source>
        <translation>夹具夹紧处没有毛坯。</translation>
    </message>
    <message>
        <source>The fixture doesn&apos;t touch the stock: a gap of %1 remains.</source>
        <translation>夹具没有接触毛坯：还有 %1 的间隙。</translation>
    </message>
</context>
<context>
    <name>burin::FixtureDrawing</name>
    <message>
        <source>Drawing of the fixture, to scale</source>
        <translation>夹具图，按比例绘制</translation>
    </message>
</context>
<context>
    <name>burin::FixturePlacer</name>
    <message>
        <source>Esc: cancel placing the fixture</source>
        <translation>Esc：取消放置夹具</translation>
    </message>
</context>
<context>
    <name>burin::GizmoTool</name>
    <message>
        <source>Esc: back to where it was</source>
        <translation>Esc：退回原位置</translation>
    </message>
</context>
<context>
    <name>burin::GuideCard</name>
    <message>
        <source>Step-over</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Switch this guide on or off</source>
        <translation>启用或停用此导向</translation>
    </message>
    <message>
        <source>Delete this guide</source>
        <translation>删除此导向</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>垂直于</translation>
    </message>
    <message>
        <source>Where the plane is</source>
        <translation>平面的位置</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>移动方式</translation>
    </message>
    <message>
        <source>Where the line is</source>
        <translation>直线的位置</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distance of the cutter from the part</source>
        <translation>铣刀到零件的距离</translation>
    </message>
    <message>
        <source>Distance of the next pass from the last one</source>
        <translation>下一次走刀与上一次走刀的距离</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>前倾</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>侧倾</translation>
    </message>
    <message>
        <source>From the part&apos;s surface</source>
        <translation>以零件表面为基准</translation>
    </message>
    <message>
        <source>Lead and tilt start from the part&apos;s surface, else from the Z axis</source>
        <translation>前倾和侧倾以零件表面为基准，否则以 Z 轴为基准</translation>
    </message>
    <message>
        <source>active on level %1</source>
        <translation>在第%1层起作用</translation>
    </message>
    <message>
        <source>active</source>
        <translation>起作用</translation>
    </message>
    <message>
        <source>waits for another</source>
        <translation>等待另一个导向</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>相距%1</translation>
    </message>
    <message>
        <source>Axis of the setup along which the levels follow each other</source>
        <translation>各层沿装夹的哪个轴依次排列</translation>
    </message>
    <message>
        <source>Distance between levels</source>
        <translation>层间距</translation>
    </message>
    <message>
        <source>Position of one of the levels</source>
        <translation>其中一层的位置</translation>
    </message>
    <message>
        <source>Lead angle: the tool leans in the direction of motion</source>
        <translation>前倾角：刀具向运动方向倾斜</translation>
    </message>
    <message>
        <source>Tilt angle: the tool leans to the left of the direction of motion</source>
        <translation>侧倾角：刀具向运动方向的左侧倾斜</translation>
    </message>
</context>
<context>
    <name>burin::GuideController</name>
    <message>
        <source>Following the part&apos;s edges</source>
        <translation>正在追踪零件的边</translation>
    </message>
    <message>
        <source>new guide</source>
        <translation>新建导向</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>导向</translation>
    </message>
    <message>
        <source>guide deleted</source>
        <translation>删除导向</translation>
    </message>
</context>
<context>
    <name>burin::GuidePanel</name>
    <message>
        <source>Guides</source>
        <translation>导向</translation>
    </message>
    <message>
        <source>There is no guide yet. A guide attracts the tool nearby, and releases it when it is pushed away.</source>
        <translation>还没有导向。导向会吸引附近的刀具，刀具被推开时则将其释放。</translation>
    </message>
    <message>
        <source>Guides on</source>
        <translation>启用导向</translation>
    </message>
    <message>
        <source>Switch all guides on or off</source>
        <translation>启用或停用所有导向</translation>
    </message>
    <message>
        <source>Kind of guide</source>
        <translation>导向类型</translation>
    </message>
    <message>
        <source>Kind of guide to add</source>
        <translation>要添加的导向类型</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Level above</source>
        <translation>上一层</translation>
    </message>
    <message>
        <source>Level below</source>
        <translation>下一层</translation>
    </message>
    <message>
        <source>No more guides can be added. Delete one first.</source>
        <translation>不能再添加导向。先删除一个。</translation>
    </message>
    <message>
        <source>This part is a mesh, which has no edges to follow.</source>
        <translation>此零件是网格，没有可沿着走的边。</translation>
    </message>
    <message>
        <source>A guide along the edge of the part that is nearest to the tool</source>
        <translation>沿零件上离刀具最近的边的导向</translation>
    </message>
    <message>
        <source>Adds a guide. If guides contradict each other, the upper one applies</source>
        <translation>添加导向。导向互相冲突时，以上面的为准</translation>
    </message>
    <message>
        <source>No guide has levels or passes.</source>
        <translation>没有带层或走刀的导向。</translation>
    </message>
    <message>
        <source>Press Mill first.</source>
        <translation>先按“铣削”。</translation>
    </message>
    <message>
        <source>The guide takes the next level above, or ends the pass</source>
        <translation>导向转到上一层，或结束当前走刀</translation>
    </message>
    <message>
        <source>The guide takes the next level below, or ends the pass</source>
        <translation>导向转到下一层，或结束当前走刀</translation>
    </message>
</context>
<context>
    <name>burin::HandController</name>
    <message>
        <source>scale of the hand</source>
        <translation>手的比例</translation>
    </message>
    <message>
        <source>alignment of the hand</source>
        <translation>手的对齐</translation>
    </message>
    <message>
        <source>control of the hand</source>
        <translation>手的控制方式</translation>
    </message>
    <message>
        <source>clutch button</source>
        <translation>离合按钮</translation>
    </message>
    <message>
        <source>level button</source>
        <translation>换层按钮</translation>
    </message>
    <message>
        <source>force button</source>
        <translation>力按钮</translation>
    </message>
</context>
<context>
    <name>burin::HandKeys</name>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Moves the tool above the workpiece.</source>
        <translation>在工件上方移动刀具。</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>左键拖动</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>Raises and lowers the tool.</source>
        <translation>升降刀具。</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>右键拖动</translation>
    </message>
    <message>
        <source>Rotates the view.</source>
        <translation>旋转视图。</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>Move the tool by a voxel.</source>
        <translation>将刀具移动一个体素。</translation>
    </message>
    <message>
        <source>Page up, down</source>
        <translation>Page Up、Page Down</translation>
    </message>
    <message>
        <source>Raise and lower the tool.</source>
        <translation>升降刀具。</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格键</translation>
    </message>
    <message>
        <source>Keeps the spindle on.</source>
        <translation>保持主轴运转。</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>Selects a point of the path, or a move of the program.</source>
        <translation>选择刀路的一个点，或程序的一次移动。</translation>
    </message>
    <message>
        <source>Shift and click</source>
        <translation>Shift+单击</translation>
    </message>
    <message>
        <source>Selects everything from the last selected point to this one.</source>
        <translation>选择从上次所选的点到此点之间的全部。</translation>
    </message>
    <message>
        <source>Moves the point; while something is drawn, draws it.</source>
        <translation>移动点；正在绘制时则进行绘制。</translation>
    </message>
    <message>
        <source>Cancels the current action, else clears the selection.</source>
        <translation>取消当前操作，否则清除选择。</translation>
    </message>
    <message>
        <source>Right or middle drag</source>
        <translation>右键或中键拖动</translation>
    </message>
    <message>
        <source>Rotates the view about the point under the pointer.</source>
        <translation>绕指针下的点旋转视图。</translation>
    </message>
    <message>
        <source>Shift and middle drag</source>
        <translation>Shift+中键拖动</translation>
    </message>
    <message>
        <source>Pans the view; so does a drag with both buttons.</source>
        <translation>平移视图；同时按住两个键拖动也可以。</translation>
    </message>
    <message>
        <source>Zooms in on the point under the pointer.</source>
        <translation>以指针下的点为中心放大。</translation>
    </message>
    <message>
        <source>Click on the cube</source>
        <translation>单击立方体</translation>
    </message>
    <message>
        <source>Looks at that side.</source>
        <translation>正视该面。</translation>
    </message>
    <message>
        <source>Cuts a stroke, or draws the rectangle of a raster.</source>
        <translation>切削一条笔画，或拉出行切的矩形。</translation>
    </message>
    <message>
        <source>Cuts a straight line from the end of the last stroke.</source>
        <translation>从上一条笔画的终点切削一条直线。</translation>
    </message>
    <message>
        <source>X, Y</source>
        <translation>X, Y</translation>
    </message>
    <message>
        <source>Locks strokes to X or to Y; again to unlock.</source>
        <translation>将笔画锁定到 X 或 Y；再按一次解锁。</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Locks strokes to their direction; again to unlock.</source>
        <translation>将笔画锁定到其方向；再按一次解锁。</translation>
    </message>
    <message>
        <source>Fine motion of a stroke and of the wheel.</source>
        <translation>笔画和滚轮的微动。</translation>
    </message>
    <message>
        <source>Ends the stroke, then stops milling.</source>
        <translation>结束笔画，然后停止铣削。</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>右键单击</translation>
    </message>
    <message>
        <source>Opens the menu of a point of the path.</source>
        <translation>打开刀路上一点的菜单。</translation>
    </message>
    <message>
        <source>Click, left drag</source>
        <translation>单击、左键拖动</translation>
    </message>
    <message>
        <source>Places the fixture on the stock, or on the table beside it.</source>
        <translation>把夹具放在毛坯上或旁边的工作台上。</translation>
    </message>
    <message>
        <source>Move it by 1 mm; with Shift by 0.1 mm, with Ctrl by 10 mm.</source>
        <translation>移动 1 mm；按住 Shift 为 0.1 mm，按住 Ctrl 为 10 mm。</translation>
    </message>
    <message>
        <source>Raise and lower it, by the same steps.</source>
        <translation>以同样的步长升降。</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Rotates it by 15°; with Shift by 90°.</source>
        <translation>旋转 15°；按住 Shift 旋转 90°。</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>回车</translation>
    </message>
    <message>
        <source>Adds it to the setup.</source>
        <translation>添加到装夹中。</translation>
    </message>
    <message>
        <source>Cancels placing.</source>
        <translation>取消放置。</translation>
    </message>
    <message>
        <source>Drag a handle</source>
        <translation>拖动手柄</translation>
    </message>
    <message>
        <source>Moves or rotates the part or a fixture; with Shift finely, with Ctrl in steps. Esc takes it back.</source>
        <translation>移动或旋转零件或夹具；按住 Shift 微调，按住 Ctrl 按步进。Esc 退回。</translation>
    </message>
</context>
<context>
    <name>burin::HandPanel</name>
    <message>
        <source>Hand and tool</source>
        <translation>手与刀具</translation>
    </message>
    <message>
        <source>Clutch button</source>
        <translation>离合按钮</translation>
    </message>
    <message>
        <source>Level button</source>
        <translation>换层按钮</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Dead man&apos;s switch: the stylus has forces only while this button is held</source>
        <translation>按住启用：只有按住此按钮时触笔才有力</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>Heat of the motors</source>
        <translation>电机发热</translation>
    </message>
    <message>
        <source>Share of the motors&apos; limit, as the device reports it</source>
        <translation>设备报告的电机发热占其极限的比例</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Tool movement divided by hand movement</source>
        <translation>刀具移动量除以手的移动量</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>离合</translation>
    </message>
    <message>
        <source>Recentre</source>
        <translation>回中</translation>
    </message>
    <message>
        <source>Align with the view</source>
        <translation>与视图对齐</translation>
    </message>
    <message>
        <source>By position</source>
        <translation>按位置</translation>
    </message>
    <message>
        <source>The tool follows the position of the hand</source>
        <translation>刀具跟随手的位置</translation>
    </message>
    <message>
        <source>By speed</source>
        <translation>按速度</translation>
    </message>
    <message>
        <source>The farther the stylus is from its centre, the faster the tool moves</source>
        <translation>触笔离中心越远，刀具移动越快</translation>
    </message>
    <message>
        <source>while button %1 is held (spindle)</source>
        <translation>按住按钮%1时（主轴）</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>按钮%1</translation>
    </message>
    <message>
        <source>The hand moves, the tool stays</source>
        <translation>手移动，刀具不动</translation>
    </message>
    <message>
        <source>A hand movement to the right moves the tool to the right in the view</source>
        <translation>手向右移动时，刀具在视图中向右移动</translation>
    </message>
    <message>
        <source>Brings the hand back to the centre of the device&apos;s workspace while you work</source>
        <translation>工作时将手逐渐带回设备工作空间的中心</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>always</source>
        <translation>始终</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>先停止录制。</translation>
    </message>
    <message>
        <source>%1, charging</source>
        <translation>%1，正在充电</translation>
    </message>
    <message>
        <source>The mouse points into the view directly. The movements of a device are scaled here.</source>
        <translation>鼠标直接指向视图。设备的移动在此缩放。</translation>
    </message>
    <message>
        <source>The tool does not move while this button of the stylus is held</source>
        <translation>按住触笔的此按钮时，刀具不移动</translation>
    </message>
    <message>
        <source>This button of the stylus requests the next lower level, or ends a pass</source>
        <translation>触笔的此按钮转到下一层（更低），或结束走刀</translation>
    </message>
    <message>
        <source>with button 1</source>
        <translation>按住按钮 1 时</translation>
    </message>
</context>
<context>
    <name>burin::HelpDialog</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>搜索帮助</translation>
    </message>
    <message>
        <source>Only topics that contain these words are shown.</source>
        <translation>只显示包含这些词的主题。</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Page of the help</source>
        <translation>帮助页面</translation>
    </message>
    <message>
        <source>No topic contains these words.</source>
        <translation>没有包含这些词的主题。</translation>
    </message>
</context>
<context>
    <name>burin::HolePicker</name>
    <message>
        <source>Esc or Enter: back to the pass</source>
        <translation>Esc 或 Enter：返回走刀</translation>
    </message>
</context>
<context>
    <name>burin::HolePresenter</name>
    <message>
        <source>Click the holes of the pass; a second click removes a hole. Enter or Esc goes back to the pass.</source>
        <translation>单击走刀的孔；再次单击则移除该孔。按 Enter 或 Esc 返回走刀。</translation>
    </message>
    <message>
        <source>Removed: %1.</source>
        <translation>已移除：%1。</translation>
    </message>
    <message>
        <source>Picked: %1.</source>
        <translation>已选：%1。</translation>
    </message>
    <message>
        <source>1 hole is picked.</source>
        <translation>已选 1 个孔。</translation>
    </message>
    <message numerus="yes">
        <source>%n holes are picked.</source>
        <translation>
            <numerusform>已选 %n 个孔。</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no round upright hole here. Click the wall of a hole, or inside it.</source>
        <translation>此处没有竖直圆孔。请单击孔壁或孔内。</translation>
    </message>
    <message>
        <source>There is no round upright hole or stud here. Click the wall of a hole, inside it, or a stud.</source>
        <translation>此处没有竖直圆孔或圆凸台。请单击孔壁、孔内或凸台。</translation>
    </message>
    <message>
        <source>Click the holes or the studs of the pass; a second click removes one. Enter or Esc goes back to the pass.</source>
        <translation>请单击走刀的孔或凸台；再次单击则移除。按 Enter 或 Esc 返回走刀。</translation>
    </message>
    <message>
        <source>1 stud is picked.</source>
        <translation>已选 1 个凸台。</translation>
    </message>
    <message numerus="yes">
        <source>%n studs are picked.</source>
        <translation>
            <numerusform>已选 %n 个凸台。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>burin::JobEvaluation</name>
    <message>
        <source>Editing the path</source>
        <translation>正在编辑刀路</translation>
    </message>
</context>
<context>
    <name>burin::JobPresenter</name>
    <message>
        <source>importing</source>
        <translation>正在导入</translation>
    </message>
    <message>
        <source>import one</source>
        <translation>导入零件</translation>
    </message>
    <message>
        <source>no part yet</source>
        <translation>还没有零件</translation>
    </message>
    <message>
        <source>can&apos;t be embedded</source>
        <translation>无法嵌入</translation>
    </message>
    <message>
        <source>embedding</source>
        <translation>正在嵌入</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>virtual operator</source>
        <translation>虚拟操作员</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>正在录制</translation>
    </message>
    <message>
        <source>no take yet</source>
        <translation>还没有录制</translation>
    </message>
    <message>
        <source>wait for the boundary</source>
        <translation>等待边界</translation>
    </message>
    <message>
        <source>embed first</source>
        <translation>先嵌入</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>不可行</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>误差%1</translation>
    </message>
    <message>
        <source>checking</source>
        <translation>正在检查</translation>
    </message>
    <message>
        <source>no path yet</source>
        <translation>还没有刀路</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>1 take</source>
        <translation>1 个录制</translation>
    </message>
    <message numerus="yes">
        <source>%n takes</source>
        <translation>
            <numerusform>%n 个录制</numerusform>
        </translation>
    </message>
    <message>
        <source>being made</source>
        <translation>正在生成</translation>
    </message>
    <message>
        <source>waits for the workpiece</source>
        <translation>等待工件</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>已编辑</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>强制放行</translation>
    </message>
    <message>
        <source>no boundary</source>
        <translation>没有边界</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>未检查</translation>
    </message>
    <message>
        <source>part doubtful</source>
        <translation>零件存疑</translation>
    </message>
    <message>
        <source>1 path</source>
        <translation>1 条刀路</translation>
    </message>
    <message numerus="yes">
        <source>%n paths</source>
        <translation>
            <numerusform>%n 条刀路</numerusform>
        </translation>
    </message>
    <message>
        <source>preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>burin::KeyList</name>
    <message>
        <source>Keys and mouse</source>
        <translation>键盘与鼠标</translation>
    </message>
    <message>
        <source>Search for a key or its effect</source>
        <translation>搜索按键或其作用</translation>
    </message>
    <message>
        <source>Only lines that contain this text are shown.</source>
        <translation>只显示包含此文本的行。</translation>
    </message>
    <message>
        <source>No key does that.</source>
        <translation>没有按键有此作用。</translation>
    </message>
</context>
<context>
    <name>burin::LayerFields</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the layer, each once</source>
        <translation>材料层的名称，不可重复</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Material of the layer</source>
        <translation>此层的材料</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>垂直于</translation>
    </message>
    <message>
        <source>Axis that both planes of the layer stand across</source>
        <translation>与材料层的两个平面垂直的轴</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Position of the plane, in the model&apos;s frame</source>
        <translation>平面在模型坐标系中的位置</translation>
    </message>
    <message>
        <source>Its values</source>
        <translation>其数值</translation>
    </message>
    <message>
        <source>The same everywhere, or changing from place to place</source>
        <translation>处处相同，或随位置变化</translation>
    </message>
    <message>
        <source>The same everywhere</source>
        <translation>处处相同</translation>
    </message>
    <message>
        <source>By a formula</source>
        <translation>按公式</translation>
    </message>
    <message>
        <source>By a table</source>
        <translation>按表格</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>变化的量</translation>
    </message>
    <message>
        <source>Value of the material that changes</source>
        <translation>材料中变化的数值</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>移动方式</translation>
    </message>
    <message>
        <source>Axis that the positions of the table lie on</source>
        <translation>表格中的位置所在的轴</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>公式</translation>
    </message>
    <message>
        <source>Of X, Y and Z in mm, as 0.4 + 0.02 * Z; or a table: position value; position value; …</source>
        <translation>以 X、Y、Z（mm）表示，如 0.4 + 0.02 * Z；或一个表格：位置 值; 位置 值; …</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>分级</translation>
    </message>
    <message>
        <source>Equally high bands that the values are sorted into</source>
        <translation>将数值归入的等高级别</translation>
    </message>
</context>
<context>
    <name>burin::LayerPanel</name>
    <message>
        <source>Layers of the stock</source>
        <translation>毛坯的材料层</translation>
    </message>
    <message>
        <source>What the stock holds</source>
        <translation>毛坯由什么组成</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>新建材料层</translation>
    </message>
    <message>
        <source>Delete the layer</source>
        <translation>删除材料层</translation>
    </message>
    <message>
        <source>Let the one before have the place</source>
        <translation>让前一层优先占据该位置</translation>
    </message>
    <message>
        <source>Let it have the place before the next</source>
        <translation>让此层优先于下一层占据该位置</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>材料层%1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1到%2</translation>
    </message>
    <message>
        <source>graded</source>
        <translation>渐变</translation>
    </message>
    <message>
        <source>%1&#xa0;g</source>
        <translation>%1 g</translation>
    </message>
    <message>
        <source>mass not known: the material has no density</source>
        <translation>质量未知：材料没有密度</translation>
    </message>
    <message>
        <source>protected</source>
        <translation>受保护</translation>
    </message>
    <message numerus="yes">
        <source>%1 from %2 to %3 %5 in %n bands: each place is within %4 %5.</source>
        <translation>
            <numerusform>%1从%2到%3 %5，分为%n级：每处偏差不超过%4 %5。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stock and material can&apos;t be changed once there are takes.</source>
        <translation>有录制之后，毛坯和材料不能再更改。</translation>
    </message>
    <message>
        <source>There is no layer.</source>
        <translation>没有材料层。</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>先导入零件。</translation>
    </message>
    <message>
        <source>No layer comes before it.</source>
        <translation>它前面没有材料层。</translation>
    </message>
    <message>
        <source>No layer comes after it.</source>
        <translation>它后面没有材料层。</translation>
    </message>
    <message>
        <source>Embed the part: then each material is listed with volume and mass.</source>
        <translation>嵌入零件：之后会列出每种材料的体积和质量。</translation>
    </message>
    <message>
        <source>Free carving: there is no part, so nothing pushes the tool back.</source>
        <translation>自由雕刻：没有零件，因此没有东西会推回刀具。</translation>
    </message>
</context>
<context>
    <name>burin::LibraryDialog</name>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Add from a file…</source>
        <translation>从文件添加…</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this window (Esc)</source>
        <translation>关闭此窗口 (Esc)</translation>
    </message>
    <message>
        <source>own</source>
        <translation>自有</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>Changed, and not saved yet.</source>
        <translation>已更改，尚未保存。</translation>
    </message>
    <message>
        <source>Nothing is changed.</source>
        <translation>没有更改。</translation>
    </message>
    <message>
        <source>Keep the changed values (Ctrl+S)</source>
        <translation>保留更改后的值 (Ctrl+S)</translation>
    </message>
    <message>
        <source>Discard the changes (Ctrl+R)</source>
        <translation>放弃更改 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Discard the changes of “%1”?</source>
        <translation>放弃对“%1”的更改？</translation>
    </message>
    <message>
        <source>They are not saved. This can&apos;t be undone.</source>
        <translation>更改尚未保存。此操作无法撤销。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>“%1” was deleted; Undo brings it back.</source>
        <translation>“%1”已删除；可用“撤销”恢复。</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Show those that contain all of these words (Ctrl+F)</source>
        <translation>显示包含所有这些词的条目 (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>burin::LoadChart</name>
    <message>
        <source>Cutting force over the machining time</source>
        <translation>加工时间上的切削力</translation>
    </message>
    <message>
        <source>Peak %1 N</source>
        <translation>峰值 %1 N</translation>
    </message>
    <message>
        <source>Force, peak %1 N</source>
        <translation>力，峰值 %1 N</translation>
    </message>
    <message>
        <source>Cutting force over the machining time without tool changes, which are dotted lines; click to go to the line that is cut at that time</source>
        <translation>加工时间上的切削力，不含换刀时间（换刀以虚线表示）；单击可转到该时间正在切削的程序行</translation>
    </message>
</context>
<context>
    <name>burin::MachineDialog</name>
    <message>
        <source>%1 (copy)</source>
        <translation>%1（副本）</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Copy this machine to one of your own and change that</source>
        <translation>将此机床复制为自有机床，再修改副本</translation>
    </message>
    <message>
        <source>Add a machine file to your own machines</source>
        <translation>将机床文件添加到自有机床</translation>
    </message>
    <message>
        <source>Use for this project</source>
        <translation>用于此项目</translation>
    </message>
    <message>
        <source>typical</source>
        <translation>典型</translation>
    </message>
    <message>
        <source>Typical values of its class, which can&apos;t be changed. Copy the machine and enter the values of your own.</source>
        <translation>同类机床的典型值，不能更改。复制该机床并输入自己机床的值。</translation>
    </message>
    <message>
        <source>Your own machine.</source>
        <translation>自有机床。</translation>
    </message>
    <message>
        <source>The machines that Burin is shipped with can&apos;t be deleted.</source>
        <translation>Burin 自带的机床不能删除。</translation>
    </message>
    <message>
        <source>Delete this machine; Undo brings it back (Del in the list)</source>
        <translation>删除此机床；可用“撤销”恢复（在列表中按 Del）</translation>
    </message>
    <message>
        <source>The programs are for this machine.</source>
        <translation>程序用于此机床。</translation>
    </message>
    <message>
        <source>Make the programs of this project for this machine (Ctrl+Return)</source>
        <translation>为此机床生成本项目的程序 (Ctrl+Return)</translation>
    </message>
    <message>
        <source>There is a machine with the ID “%1” already; give the one in the file another ID.</source>
        <translation>已有 ID 为“%1”的机床；给文件中的机床换一个 ID。</translation>
    </message>
</context>
<context>
    <name>burin::MachineForm</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>NC dialect that the machine&apos;s control reads</source>
        <translation>机床控制系统读取的 NC 方言</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>方言</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>Travel X, Y, Z</source>
        <translation>行程 X、Y、Z</translation>
    </message>
    <message>
        <source>Tool change height</source>
        <translation>换刀高度</translation>
    </message>
    <message>
        <source>Height above program zero that is always free; below the travel of Z</source>
        <translation>程序零点以上始终无障碍的高度；小于 Z 轴行程</translation>
    </message>
    <message>
        <source>Tool change time</source>
        <translation>换刀时间</translation>
    </message>
    <message>
        <source>From chip to chip</source>
        <translation>从切屑到切屑</translation>
    </message>
    <message>
        <source>Feeds and rapids</source>
        <translation>进给和快速移动</translation>
    </message>
    <message>
        <source>Greatest feed</source>
        <translation>最大进给</translation>
    </message>
    <message>
        <source>While it cuts</source>
        <translation>切削时</translation>
    </message>
    <message>
        <source>Rapid feed</source>
        <translation>快移速度</translation>
    </message>
    <message>
        <source>Of the fastest axis</source>
        <translation>最快轴的速度</translation>
    </message>
    <message>
        <source>Greatest rate X, Y, Z</source>
        <translation>最大速度 X、Y、Z</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>快速移动</translation>
    </message>
    <message>
        <source>Straight, all axes arrive together</source>
        <translation>直线，所有轴同时到达</translation>
    </message>
    <message>
        <source>Each axis at its own rate (with bends)</source>
        <translation>各轴按自身速度（路径有折弯）</translation>
    </message>
    <message>
        <source>Straight, the tip at the rapid feed</source>
        <translation>直线，刀尖以快移速度移动</translation>
    </message>
    <message>
        <source>Accelerations</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Acceleration X, Y, Z</source>
        <translation>加速度 X、Y、Z</translation>
    </message>
    <message>
        <source>Of each axis</source>
        <translation>每个轴的值</translation>
    </message>
    <message>
        <source>Jerk X, Y, Z</source>
        <translation>加加速度 X、Y、Z</translation>
    </message>
    <message>
        <source>Limit of each axis</source>
        <translation>每个轴的限值</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>最低转速</translation>
    </message>
    <message>
        <source>At most the highest speed</source>
        <translation>不超过最高转速</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高转速</translation>
    </message>
    <message>
        <source>Above 0</source>
        <translation>大于 0</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>功率</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>冷却液</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Mist</source>
        <translation>喷雾</translation>
    </message>
    <message>
        <source>Flood</source>
        <translation>浇注</translation>
    </message>
    <message>
        <source>Mist and flood</source>
        <translation>喷雾和浇注</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制系统</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>拐角</translation>
    </message>
    <message>
        <source>Exact stop</source>
        <translation>准停</translation>
    </message>
    <message>
        <source>As an arc within the tolerance</source>
        <translation>公差内的圆弧</translation>
    </message>
    <message>
        <source>Blended within the tolerance</source>
        <translation>公差内平滑过渡</translation>
    </message>
    <message>
        <source>Tolerance of corners</source>
        <translation>拐角公差</translation>
    </message>
    <message>
        <source>Decimal places</source>
        <translation>小数位数</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Largest sweep</source>
        <translation>最大圆心角</translation>
    </message>
    <message>
        <source>Of one block; 360° is a full circle</source>
        <translation>单个程序段的角度；360° 为整圆</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>Below the largest radius</source>
        <translation>小于最大半径</translation>
    </message>
    <message>
        <source>Largest radius</source>
        <translation>最大半径</translation>
    </message>
    <message>
        <source>Larger arcs are written as lines</source>
        <translation>更大的圆弧按直线输出</translation>
    </message>
    <message>
        <source>Difference of the radii</source>
        <translation>半径差</translation>
    </message>
    <message>
        <source>Allowed between start and end of an arc</source>
        <translation>圆弧起点与终点之间的允许值</translation>
    </message>
    <message>
        <source>Torque over speed</source>
        <translation>扭矩-转速曲线</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>停放位置</translation>
    </message>
    <message>
        <source>Home X, Y, Z</source>
        <translation>停放位置 X、Y、Z</translation>
    </message>
    <message>
        <source>At a machine position</source>
        <translation>位于机床坐标位置</translation>
    </message>
    <message>
        <source>In machine coordinates, no farther from machine zero than the travel. Z is moved first, straight from above the work, so it has to be the top of the travel</source>
        <translation>机床坐标，离机床零点不超过行程。Z 轴最先移动，从工件上方直接上升，因此 Z 值必须是行程的最高点</translation>
    </message>
    <message>
        <source>Continuous torque of the spindle. Between two points the power follows a straight line; without points: not stated</source>
        <translation>主轴的连续扭矩。两点之间功率按直线变化；没有点：未给出</translation>
    </message>
    <message>
        <source>Name in the list of machines</source>
        <translation>机床列表中的名称</translation>
    </message>
    <message>
        <source>Source of the values that have none of their own</source>
        <translation>没有单独来源的值的来源</translation>
    </message>
    <message>
        <source>Travel of each axis</source>
        <translation>每个轴的行程</translation>
    </message>
    <message>
        <source>Parking position of the spindle for a tool change and at the end of a program (G53), if the dialect supports it</source>
        <translation>换刀和程序结束时主轴的停放位置 (G53)，前提是方言支持</translation>
    </message>
    <message>
        <source>Maximum feed of each axis; at most the rapid feed, which applies to axes without a value</source>
        <translation>每个轴的最大进给；不超过快移速度，没有值的轴采用快移速度</translation>
    </message>
    <message>
        <source>Motion of several axes in a rapid</source>
        <translation>快速移动时多轴的运动方式</translation>
    </message>
    <message>
        <source>For axes without a value of their own</source>
        <translation>用于没有单独值的轴</translation>
    </message>
    <message>
        <source>Continuous power of the spindle</source>
        <translation>主轴的连续功率</translation>
    </message>
    <message>
        <source>Coolant that the machine can switch on</source>
        <translation>机床能开启的冷却液</translation>
    </message>
    <message>
        <source>Motion from one block to the next</source>
        <translation>从一个程序段到下一个程序段的运动</translation>
    </message>
    <message>
        <source>Largest distance of the motion from a corner; above 0 unless the machine stops there</source>
        <translation>运动偏离拐角的最大距离；除非机床在拐角处停止，否则大于 0</translation>
    </message>
    <message>
        <source>Blocks per second</source>
        <translation>每秒程序段数</translation>
    </message>
    <message>
        <source>Maximum that the control executes</source>
        <translation>控制系统能执行的最大值</translation>
    </message>
    <message>
        <source>Decimal places of a coordinate in mm</source>
        <translation>坐标（mm）的小数位数</translation>
    </message>
    <message>
        <source>Characters per line</source>
        <translation>每行字符数</translation>
    </message>
    <message>
        <source>Maximum that the control reads</source>
        <translation>控制系统能读取的最大值</translation>
    </message>
    <message>
        <source>as stated in the machine&apos;s source</source>
        <translation>按机床来源所述</translation>
    </message>
</context>
<context>
    <name>burin::MainWindow</name>
    <message>
        <source>Delete this work?</source>
        <translation>删除这项工作？</translation>
    </message>
    <message>
        <source>It was never saved. This can&apos;t be undone.</source>
        <translation>它从未保存。此操作无法撤销。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>%1[*] — Burin</source>
        <translation>%1[*] — Burin</translation>
    </message>
    <message>
        <source>Burin</source>
        <translation>Burin</translation>
    </message>
    <message>
        <source>The program was written to “%1”.</source>
        <translation>程序已写入“%1”。</translation>
    </message>
    <message>
        <source>The folder can&apos;t be written, so this project is open for reading only; save it elsewhere to change it.</source>
        <translation>文件夹不可写，因此项目以只读方式打开；要更改项目，先另存到别处。</translation>
    </message>
    <message>
        <source>The battery of “%1” is down to %2; charge it soon.</source>
        <translation>“%1”的电量只剩%2；尽快充电。</translation>
    </message>
    <message>
        <source>Burin ended before this work was saved; everything that was entered and recorded is restored.</source>
        <translation>Burin 在这项工作保存之前退出；所有输入和录制的内容都已恢复。</translation>
    </message>
    <message>
        <source>Mouse in the view</source>
        <translation>视图中的鼠标操作</translation>
    </message>
    <message>
        <source>In mill mode</source>
        <translation>铣削模式下</translation>
    </message>
    <message>
        <source>On the path</source>
        <translation>在刀路上</translation>
    </message>
    <message>
        <source>Drag to make the panel wider or narrower</source>
        <translation>拖动可调整面板宽度</translation>
    </message>
    <message>
        <source>Esc: back to the project</source>
        <translation>Esc：返回项目</translation>
    </message>
    <message>
        <source>The rest of the program from line %1 on passed its check and was written to “%2”.</source>
        <translation>程序从第%1行起的剩余部分已通过检查，并写入“%2”。</translation>
    </message>
    <message>
        <source>Older unsaved work no longer belongs to this file; it was moved to “%1”.</source>
        <translation>较早的未保存工作已不属于此文件；已移到“%1”。</translation>
    </message>
    <message>
        <source>An earlier version of Burin saved this project; the previous file is kept as “%1”.</source>
        <translation>此项目由较早版本的 Burin 保存；原文件保留为“%1”。</translation>
    </message>
    <message>
        <source>The workpiece was written to “%1”.</source>
        <translation>工件已写入“%1”。</translation>
    </message>
    <message>
        <source>“%1” gives no unit of length; it was read in mm.</source>
        <translation>“%1”没有给出长度单位；已按 mm 读取。</translation>
    </message>
    <message>
        <source>The tool “%1” is in the library. Its profile is at most %2 mm wider than what its flutes sweep, and never narrower.</source>
        <translation>刀具“%1”已加入刀具库。其轮廓最多比刃部扫过的范围宽 %2 mm，绝不会更窄。</translation>
    </message>
    <message>
        <source>The stock was rotated by an angle that is not a multiple of 90°. Its faces may be off by up to %1 mm; use smaller voxels to reduce this.</source>
        <translation>毛坯的旋转角度不是 90° 的倍数。其各面的偏差可达 %1 mm；使用更小的体素可减小偏差。</translation>
    </message>
    <message>
        <source>The setup sheet was written to “%1”.</source>
        <translation>装夹单已写入“%1”。</translation>
    </message>
    <message>
        <source>The part has not changed.</source>
        <translation>零件没有变化。</translation>
    </message>
    <message>
        <source>Changed bodies: %1.</source>
        <translation>有变化的实体：%1。</translation>
    </message>
    <message>
        <source>New bodies: %1.</source>
        <translation>新增的实体：%1。</translation>
    </message>
    <message>
        <source>Removed bodies: %1.</source>
        <translation>移除的实体：%1。</translation>
    </message>
    <message>
        <source>Stock and program zero stay where they are; check the programs again.</source>
        <translation>毛坯和程序零点位置不变；重新检查程序。</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Hide the timeline</source>
        <translation>隐藏时间轴</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史记录</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>打开时的状态</translation>
    </message>
    <message>
        <source>Click an entry to undo or redo everything up to there.</source>
        <translation>单击一项可撤销或重做到该处为止的所有操作。</translation>
    </message>
    <message>
        <source>Hide the history</source>
        <translation>隐藏历史记录</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Hide the project tree</source>
        <translation>隐藏项目树</translation>
    </message>
    <message>
        <source>1 dwell was left out.</source>
        <translation>略去了 1 个暂停。</translation>
    </message>
    <message numerus="yes">
        <source>%n dwells were left out.</source>
        <translation>
            <numerusform>略去了%n个暂停。</numerusform>
        </translation>
    </message>
    <message>
        <source>1 move was left out: the program does not state where it begins.</source>
        <translation>略去了 1 个移动：程序没有给出它的起点。</translation>
    </message>
    <message numerus="yes">
        <source>%n moves were left out: the program does not state where they begin.</source>
        <translation>
            <numerusform>略去了%n个移动：程序没有给出它们的起点。</numerusform>
        </translation>
    </message>
    <message>
        <source>The picture was written to “%1”.</source>
        <translation>图片已写入“%1”。</translation>
    </message>
    <message>
        <source>A path was made of %1 of feed moves, with the feeds and speeds of the program. Links replace its rapids.</source>
        <translation>已由%1的进给移动生成刀路，采用程序的进给和转速。程序的快速移动由连接代替。</translation>
    </message>
    <message>
        <source>1 arc was converted to lines within 0.001 mm; “Fit arcs” restores it.</source>
        <translation>1 个圆弧已转换为直线，误差不超过 0.001 mm；“拟合圆弧”可恢复它。</translation>
    </message>
    <message numerus="yes">
        <source>%n arcs were converted to lines within 0.001 mm; “Fit arcs” restores them.</source>
        <translation>
            <numerusform>%n个圆弧已转换为直线，误差不超过 0.001 mm；“拟合圆弧”可恢复它们。</numerusform>
        </translation>
    </message>
    <message>
        <source>The table of faces was written to “%1”.</source>
        <translation>面的表格已写入“%1”。</translation>
    </message>
    <message>
        <source>View of part and workpiece</source>
        <translation>零件和工件的视图</translation>
    </message>
    <message>
        <source>Placing a fixture</source>
        <translation>放置夹具</translation>
    </message>
    <message>
        <source>The tool “%1” is in the library. It doesn&apos;t turn: its models cut, and their profile keeps them out of the part.</source>
        <translation>刀具“%1”已在刀具库中。它不旋转：由其模型切削，轮廓把它们挡在零件之外。</translation>
    </message>
    <message>
        <source>Switched to “%1”, where the change was made.</source>
        <translation>已切换到“%1”，更改是在那里做的。</translation>
    </message>
    <message>
        <source>The tool “%1” is in the library. It is hollow, %2 mm in diameter and %3 mm deep, and leaves a core there; its outside is at most %4 mm wider than what its flutes sweep.</source>
        <translation>刀具“%1”已加入刀具库。它是空心的，直径 %2 mm，深 %3 mm，会在其中留下芯柱；其外侧最多比刀刃扫过的形状宽 %4 mm。</translation>
    </message>
    <message>
        <source>The trace of the session was written to “%1”.</source>
        <translation>会话轨迹已写入“%1”。</translation>
    </message>
</context>
<context>
    <name>burin::MaterialController</name>
    <message>
        <source>copy of a material</source>
        <translation>复制材料</translation>
    </message>
    <message>
        <source>values of a material</source>
        <translation>材料的值</translation>
    </message>
    <message>
        <source>deleting a material</source>
        <translation>删除材料</translation>
    </message>
</context>
<context>
    <name>burin::MaterialDialog</name>
    <message>
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Copy this material to one of your own and change that</source>
        <translation>将此材料复制为自有材料，再修改副本</translation>
    </message>
    <message>
        <source>Add a material file, or a material card of FreeCAD (.FCMat)</source>
        <translation>添加材料文件，或 FreeCAD 的材料卡 (.FCMat)</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>标定…</translation>
    </message>
    <message>
        <source>Fit K and Kr to measured cutting forces (CSV)</source>
        <translation>用实测切削力 (CSV) 拟合 K 和 Kr</translation>
    </message>
    <message>
        <source>shipped</source>
        <translation>自带</translation>
    </message>
    <message>
        <source>Burin is shipped with this material, which can&apos;t be changed. Copy it and change the copy.</source>
        <translation>此材料是 Burin 自带的，不能更改。复制它，再修改副本。</translation>
    </message>
    <message>
        <source>Your own material. The open project has recordings and keeps the values that they were made with.</source>
        <translation>自有材料。打开的项目已有录制，会保留录制时所用的值。</translation>
    </message>
    <message>
        <source>Your own material.</source>
        <translation>自有材料。</translation>
    </message>
    <message>
        <source>The materials that Burin is shipped with can&apos;t be deleted.</source>
        <translation>Burin 自带的材料不能删除。</translation>
    </message>
    <message>
        <source>Delete this material; Undo brings it back (Del in the list)</source>
        <translation>删除此材料；可用“撤销”恢复（在列表中按 Del）</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1（副本）</translation>
    </message>
    <message>
        <source>There is a material with the ID “%1” already; give the one in the file another ID.</source>
        <translation>已有 ID 为“%1”的材料；给文件中的材料换一个 ID。</translation>
    </message>
</context>
<context>
    <name>burin::MaterialForm</name>
    <message>
        <source>K: energy to cut a volume; the cutting force comes from it</source>
        <translation>K：切除单位体积所需的能量；由它得出切削力</translation>
    </message>
    <message>
        <source>Kr: force along the tool axis over that against the feed</source>
        <translation>Kr：沿刀轴的力与进给反方向的力之比</translation>
    </message>
    <message>
        <source>kc1.1 of Kienzle&apos;s law; stands for K together with mc</source>
        <translation>Kienzle 公式的 kc1.1；与 mc 一起代替 K</translation>
    </message>
    <message>
        <source>mc of Kienzle&apos;s law</source>
        <translation>Kienzle 公式的 mc</translation>
    </message>
    <message>
        <source>Density; masses come from it</source>
        <translation>密度；由它得出质量</translation>
    </message>
    <message>
        <source>Cutting speed with carbide; the spindle speed comes from it</source>
        <translation>硬质合金刀具的切削速度；由它得出主轴转速</translation>
    </message>
    <message>
        <source>Plunge feed over feed</source>
        <translation>垂直下刀进给与进给之比</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>In which it is drawn</source>
        <translation>绘制时所用的颜色</translation>
    </message>
    <message>
        <source>Values of the material</source>
        <translation>材料的特性值</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>特性</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>Add a value</source>
        <translation>添加特性值</translation>
    </message>
    <message>
        <source>Remove the value</source>
        <translation>移除特性值</translation>
    </message>
    <message>
        <source>Nobody published this number: calibrate before you trust what depends on it</source>
        <translation>这个数值没有公开发表的出处：在信赖依赖它的结果之前先标定</translation>
    </message>
    <message>
        <source>A value has no name; enter one, or remove the row.</source>
        <translation>有一个值没有名称；输入名称，或移除该行。</translation>
    </message>
    <message>
        <source>“%1” of “%2” is no number; enter one, with a decimal point.</source>
        <translation>“%2”的“%1”不是数字；输入一个数字，使用小数点。</translation>
    </message>
    <message>
        <source>“%1” has no unit; enter one, or 1 where it has none.</source>
        <translation>“%1”没有单位；输入单位，无单位时输入 1。</translation>
    </message>
    <message>
        <source>“%1” has no source; enter where the number comes from.</source>
        <translation>“%1”没有来源；输入数值的出处。</translation>
    </message>
    <message>
        <source>Two values have the same name; rename one of them.</source>
        <translation>两个值的名称相同；重命名其中一个。</translation>
    </message>
    <message>
        <source>Chip load per tooth, as a share of the diameter; the feed follows from it</source>
        <translation>每齿进给量，以直径的比例表示；由它得出进给</translation>
    </message>
    <message>
        <source>A property of your own, kept with the material</source>
        <translation>自定义特性，与材料一起保存</translation>
    </message>
    <message>
        <source>Name in the list of materials</source>
        <translation>材料列表中的名称</translation>
    </message>
    <message>
        <source>Add a property of your own</source>
        <translation>添加自定义特性</translation>
    </message>
    <message>
        <source>%1; used instead of the value for all cutters</source>
        <translation>%1；代替适用于所有铣刀的值</translation>
    </message>
</context>
<context>
    <name>burin::MaterialPanel</name>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>Its material</source>
        <translation>实体的材料</translation>
    </message>
    <message>
        <source>Values of the material</source>
        <translation>材料的特性值</translation>
    </message>
    <message>
        <source>Source of the selected value</source>
        <translation>所选特性值的来源</translation>
    </message>
    <message>
        <source>Stock and material can&apos;t be changed once there are takes.</source>
        <translation>有录制之后，毛坯和材料不能再更改。</translation>
    </message>
    <message>
        <source>The material can be changed until the first take; the workpiece is kept.</source>
        <translation>首次录制之前可以更改材料；工件保持不变。</translation>
    </message>
    <message>
        <source>Values of %1</source>
        <translation>%1的特性值</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>特性值</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>1 value is an estimate: calibrate it before you rely on results that depend on it.</source>
        <translation>有 1 个值是估计值：在依靠与它有关的结果之前先标定。</translation>
    </message>
    <message numerus="yes">
        <source>%n values are estimates: calibrate them before you rely on results that depend on them.</source>
        <translation>
            <numerusform>有%n个值是估计值：在依靠与它们有关的结果之前先标定。</numerusform>
        </translation>
    </message>
    <message>
        <source>Same as the stock</source>
        <translation>与毛坯相同</translation>
    </message>
    <message>
        <source>Material of the stock</source>
        <translation>毛坯的材料</translation>
    </message>
    <message>
        <source>Body whose material is shown below</source>
        <translation>下方显示其材料的实体</translation>
    </message>
    <message>
        <source>Material of this body</source>
        <translation>此实体的材料</translation>
    </message>
</context>
<context>
    <name>burin::MeasureController</name>
    <message>
        <source>Measuring</source>
        <translation>测量</translation>
    </message>
</context>
<context>
    <name>burin::MeasurePicker</name>
    <message>
        <source>Esc: end measuring</source>
        <translation>Esc：结束测量</translation>
    </message>
</context>
<context>
    <name>burin::MeasurePresenter</name>
    <message>
        <source>Click a point on the part to measure its face, then another one for the distance. Esc ends measuring.</source>
        <translation>单击零件上的一点可测量其所在的面，再单击另一点可测量距离。Esc 结束测量。</translation>
    </message>
    <message>
        <source>Click a point on the workpiece to measure its face and the stock that is left there, then another one for the distance. Esc ends measuring.</source>
        <translation>单击工件上的一点可测量其所在的面和该处的残料，再单击另一点可测量距离。Esc 结束测量。</translation>
    </message>
</context>
<context>
    <name>burin::Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开的文件(&amp;R)</translation>
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
        <source>&amp;Mill</source>
        <translation>铣削(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>刀路(&amp;P)</translation>
    </message>
    <message>
        <source>P&amp;rogram</source>
        <translation>程序(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Setup</source>
        <translation>装夹(&amp;S)</translation>
    </message>
</context>
<context>
    <name>burin::MessageStrip</name>
    <message>
        <source>Close this message.</source>
        <translation>关闭此消息。</translation>
    </message>
</context>
<context>
    <name>burin::MeterPresenter</name>
    <message>
        <source>Virtual operator %1 ×</source>
        <translation>虚拟操作员 %1 ×</translation>
    </message>
    <message>
        <source>the spindle&apos;s power</source>
        <translation>主轴功率</translation>
    </message>
    <message>
        <source>the spindle&apos;s torque</source>
        <translation>主轴扭矩</translation>
    </message>
    <message>
        <source>the tool may break</source>
        <translation>刀具可能折断</translation>
    </message>
    <message>
        <source>Plunge feed, because the tool plunges</source>
        <translation>垂直下刀进给，因为刀具正在垂直下刀</translation>
    </message>
    <message>
        <source>Thin chip: limited to twice the feed of the cutting data</source>
        <translation>切屑薄：限制为切削数据中进给的两倍</translation>
    </message>
    <message>
        <source>Limited by the strength of the tool or the power of the spindle</source>
        <translation>受刀具强度或主轴功率限制</translation>
    </message>
    <message>
        <source>Limited by the maximum chip load of the tool or the maximum feed of the machine</source>
        <translation>受刀具最大每齿进给量或机床最大进给限制</translation>
    </message>
    <message>
        <source>Limited by the chip load of the cutting data</source>
        <translation>受切削数据中的每齿进给量限制</translation>
    </message>
</context>
<context>
    <name>burin::Meters</name>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Removal</source>
        <translation>材料去除率</translation>
    </message>
    <message>
        <source>Haptic rate</source>
        <translation>力反馈频率</translation>
    </message>
    <message>
        <source>Work, p99.9</source>
        <translation>计算时间，p99.9</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>错过</translation>
    </message>
    <message>
        <source>Ticks that came too late</source>
        <translation>来得太迟的周期</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>触笔</translation>
    </message>
    <message>
        <source>Stylus that moves the tool</source>
        <translation>移动刀具的触笔</translation>
    </message>
    <message>
        <source>%1 N of %2</source>
        <translation>%1 N / %2</translation>
    </message>
    <message>
        <source>Tip of the tool from program zero, in %1</source>
        <translation>刀尖相对程序零点的位置，单位 %1</translation>
    </message>
    <message>
        <source>Cutting force, not scaled; next to it the highest so far</source>
        <translation>切削力，未缩放；旁边是迄今的最大值</translation>
    </message>
    <message>
        <source>Material removed per second</source>
        <translation>每秒去除的材料</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>RealtimeKit</source>
        <translation>RealtimeKit</translation>
    </message>
    <message>
        <source>raised</source>
        <translation>提高</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>普通</translation>
    </message>
    <message>
        <source>Interval, p99.9</source>
        <translation>间隔，p99.9</translation>
    </message>
    <message>
        <source>Withheld</source>
        <translation>未发送</translation>
    </message>
    <message>
        <source>Forces that were ready more than 3 ms after the one before, and not sent</source>
        <translation>与前一个力相隔超过 3 ms 才就绪、因而未发送的力</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>优先级</translation>
    </message>
    <message>
        <source>Show the values of the haptic loop</source>
        <translation>显示力反馈循环的数值</translation>
    </message>
    <message>
        <source>Hide the values of the haptic loop</source>
        <translation>隐藏力反馈循环的数值</translation>
    </message>
    <message>
        <source>%1 N, limit %2 N</source>
        <translation>%1 N，限值 %2 N</translation>
    </message>
    <message>
        <source>Cutting force at the speed of the hand, not scaled. At the limit the bar turns red: %1</source>
        <translation>按手的移动速度得出的切削力，未缩放。达到限值时指示条变红：%1</translation>
    </message>
    <message>
        <source>Ticks per second that are reached</source>
        <translation>实际达到的每秒周期数</translation>
    </message>
    <message>
        <source>Interval between two forces that 999 of 1000 do not exceed</source>
        <translation>两次力输出的间隔，1000 次中有 999 次不超过该值</translation>
    </message>
    <message>
        <source>CPU time of a tick that 999 of 1000 do not exceed</source>
        <translation>每个周期的 CPU 时间，1000 次中有 999 次不超过该值</translation>
    </message>
    <message>
        <source>Scheduling that the system grants the haptic loop; the rtprio limit or RealtimeKit gives real time</source>
        <translation>系统给予力反馈循环的调度方式；rtprio 限制或 RealtimeKit 可提供实时调度</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Feed and spindle speed for the material under the tool and its engagement, from the cutting data. Feeds of a path are set by its edits</source>
        <translation>按刀具下方的材料和吃刀量，由切削数据得出的进给和主轴转速。刀路的进给由其编辑步骤设定</translation>
    </message>
    <message>
        <source>%1, engagement %2°, depth %3. %4</source>
        <translation>%1，接触角 %2°，深度 %3。%4</translation>
    </message>
    <message>
        <source>%1, at the limit</source>
        <translation>%1，已达限值</translation>
    </message>
</context>
<context>
    <name>burin::MillController</name>
    <message>
        <source>allowance</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>name of a take</source>
        <translation>录制的名称</translation>
    </message>
    <message>
        <source>delete a take</source>
        <translation>删除录制</translation>
    </message>
    <message>
        <source>order of takes</source>
        <translation>录制的顺序</translation>
    </message>
    <message>
        <source>copy of a take</source>
        <translation>录制的副本</translation>
    </message>
    <message>
        <source>take without strokes</source>
        <translation>没有笔画的录制</translation>
    </message>
</context>
<context>
    <name>burin::MillPanel</name>
    <message>
        <source>Mill</source>
        <translation>铣削</translation>
    </message>
    <message>
        <source>How the tool follows the hand</source>
        <translation>刀具跟随手的方式</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>鼠标和按键</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>There is no stroke to undo.</source>
        <translation>没有可撤销的笔画。</translation>
    </message>
    <message>
        <source>Strokes from before the project was opened can&apos;t be undone; delete their take instead.</source>
        <translation>打开项目之前的笔画不能撤销；可改为删除其录制。</translation>
    </message>
    <message>
        <source>Undo the last stroke; no other one can be undone</source>
        <translation>撤销最后一个笔画；其他笔画不能撤销</translation>
    </message>
    <message numerus="yes">
        <source>Undo the last stroke; the last %n strokes can be undone</source>
        <translation>
            <numerusform>撤销最后一个笔画；最后%n个笔画可以撤销</numerusform>
        </translation>
    </message>
    <message>
        <source>Redo the stroke that was undone last</source>
        <translation>重做最近撤销的笔画</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Along the part</source>
        <translation>沿零件</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>切深</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>压入</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>The tool follows the pointer no faster than this while it cuts</source>
        <translation>切削时刀具跟随指针的速度不超过此值</translation>
    </message>
    <message>
        <source>Embed the part and choose a tool first.</source>
        <translation>先嵌入零件并选择刀具。</translation>
    </message>
    <message>
        <source>Stop milling</source>
        <translation>停止铣削</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>先停止录制。</translation>
    </message>
    <message>
        <source>Stop the virtual operator</source>
        <translation>停止虚拟操作员</translation>
    </message>
    <message>
        <source>The virtual operator mills the part before your eyes</source>
        <translation>虚拟操作员当场演示铣削零件</translation>
    </message>
    <message>
        <source>Stop showing</source>
        <translation>停止演示</translation>
    </message>
    <message>
        <source>A stroke stays at the height of its first point, less the depth of cut</source>
        <translation>笔画保持在其第一点的高度减去切深处</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>触笔</translation>
    </message>
    <message>
        <source>Stylus that moves the tool</source>
        <translation>移动刀具的触笔</translation>
    </message>
    <message>
        <source>Nothing is recorded yet. Everything that you mill will be; Show me demonstrates it.</source>
        <translation>还没有录制。铣削的一切都会被录制；“演示”可作示范。</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Dragging cuts along the pointer&apos;s trail</source>
        <translation>拖动即沿指针的轨迹切削</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>行切</translation>
    </message>
    <message>
        <source>Drag a rectangle; it is milled in rows at the step-over (T)</source>
        <translation>拖出一个矩形；按行距逐行铣削 (T)</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Distance between the rows of a raster, and to a stroke repeated beside the last one</source>
        <translation>行切时各行之间的距离，以及在上一笔画旁边重复笔画时的距离</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>向下</translation>
    </message>
    <message>
        <source>Repeat the last stroke, lower by the depth of cut (L)</source>
        <translation>重复上一笔画，降低一个切深 (L)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>向左</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the left of its direction (B)</source>
        <translation>在上一笔画前进方向的左侧一个行距处重复 (B)</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>向右</translation>
    </message>
    <message>
        <source>Repeat the last stroke one step-over to the right of its direction (Shift+B)</source>
        <translation>在上一笔画前进方向的右侧一个行距处重复 (Shift+B)</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Stop, recorded %1</source>
        <translation>停止，已录制%1</translation>
    </message>
    <message>
        <source>Stop milling and end the take</source>
        <translation>停止铣削并结束录制</translation>
    </message>
    <message>
        <source>Start milling. Everything that is cut is recorded</source>
        <translation>开始铣削。切削的一切都会被录制</translation>
    </message>
    <message>
        <source>A stroke is being cut. Wait until it ends, or press Esc to end it.</source>
        <translation>正在切削一个笔画。等它结束，或按 Esc 结束它。</translation>
    </message>
    <message>
        <source>Drag in the view to mill. Shift+click mills a straight line from the last end.</source>
        <translation>在视图中拖动即可铣削。Shift+单击从上一终点铣出直线。</translation>
    </message>
    <message>
        <source>Press Mill, then drag in the view.</source>
        <translation>按“铣削”，然后在视图中拖动。</translation>
    </message>
    <message>
        <source>A stroke presses onto the part; its push-back guides the tool along the surface</source>
        <translation>笔画压向零件；零件的反推力引导刀具沿表面移动</translation>
    </message>
    <message>
        <source>Depth of the tip below the surface under the pointer</source>
        <translation>刀尖在指针所指表面以下的深度</translation>
    </message>
    <message>
        <source>Depth of the hand in the part, against its push-back</source>
        <translation>手克服反推力压入零件的深度</translation>
    </message>
    <message>
        <source>Sinking speed</source>
        <translation>下沉速度</translation>
    </message>
    <message>
        <source>Speed at which the tool sinks at full pressure of the pen</source>
        <translation>笔的压力最大时刀具下沉的速度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Sinking</source>
        <translation>下沉</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>笔</translation>
    </message>
    <message>
        <source>The pressure sets the depth; at full pressure it is the depth of cut, or the press into the part</source>
        <translation>压力决定深度；压力最大时为切深，或压入零件的深度</translation>
    </message>
    <message>
        <source>The tool sinks from the surface to the depth of cut; it sinks faster the harder the pen presses</source>
        <translation>刀具从表面下沉到切深，笔压得越重下沉越快</translation>
    </message>
</context>
<context>
    <name>burin::MillPresenter</name>
    <message>
        <source>Import a part first.</source>
        <translation>先导入零件。</translation>
    </message>
    <message>
        <source>The part is being embedded.</source>
        <translation>正在嵌入零件。</translation>
    </message>
    <message>
        <source>Embed the part in its stock first.</source>
        <translation>先将零件嵌入毛坯。</translation>
    </message>
    <message>
        <source>The boundary for the tool is being computed.</source>
        <translation>正在计算刀具的边界。</translation>
    </message>
    <message>
        <source>The virtual operator is milling; stop it to mill yourself.</source>
        <translation>虚拟操作员正在铣削；要自己铣削，先停止它。</translation>
    </message>
    <message>
        <source>%1 (not plugged in)</source>
        <translation>%1（未连接）</translation>
    </message>
    <message>
        <source>There is no boundary for the tool: choose another tool, or embed again, with larger voxels where memory was short.</source>
        <translation>没有刀具的边界：选择另一把刀具，或重新嵌入；内存不足时使用更大的体素。</translation>
    </message>
    <message>
        <source>Strokes are locked to X. Press X to unlock.</source>
        <translation>笔画已锁定到 X。按 X 解锁。</translation>
    </message>
    <message>
        <source>Strokes are locked to Y. Press Y to unlock.</source>
        <translation>笔画已锁定到 Y。按 Y 解锁。</translation>
    </message>
    <message>
        <source>Strokes are locked to their direction. Press D to unlock.</source>
        <translation>笔画已锁定到其方向。按 D 解锁。</translation>
    </message>
    <message>
        <source>The tool axis is fixed, so the pen&apos;s tilt has no effect. Choose the axis “free, with the hand” in the step Stock to lean the tool.</source>
        <translation>刀轴固定，笔的倾斜不起作用。要使刀具倾斜，请在“毛坯”步骤中选择刀轴“自由，随手”。</translation>
    </message>
</context>
<context>
    <name>burin::MillTool</name>
    <message>
        <source>Esc: cancel the line</source>
        <translation>Esc：取消直线</translation>
    </message>
    <message>
        <source>Esc: cancel the raster</source>
        <translation>Esc：取消行切</translation>
    </message>
    <message>
        <source>Esc: stop milling</source>
        <translation>Esc：停止铣削</translation>
    </message>
    <message>
        <source>No direction to lock yet. Draw at least 1 mm of a stroke first.</source>
        <translation>还没有可锁定的方向。先画出至少 1 mm 的笔画。</translation>
    </message>
    <message>
        <source>The raster needs more than a million points along the part. Increase the step-over or draw a smaller rectangle.</source>
        <translation>行切沿零件需要超过一百万个点。增大行距或画更小的矩形。</translation>
    </message>
    <message>
        <source>A stroke along the part cannot be repeated lower: the part limits its depth.</source>
        <translation>沿零件的笔画不能降低重复：零件限制了其深度。</translation>
    </message>
    <message>
        <source>The depth of cut is zero. Enter a depth to repeat the stroke lower.</source>
        <translation>切深为零。输入切深才能降低重复笔画。</translation>
    </message>
    <message>
        <source>The last stroke is vertical, so it cannot be repeated beside itself.</source>
        <translation>上一笔画是竖直的，因此不能在旁边重复。</translation>
    </message>
    <message>
        <source>Esc: stop the tool here and drop what it has not milled yet</source>
        <translation>Esc：让刀具停在此处，丢弃尚未铣削的部分</translation>
    </message>
</context>
<context>
    <name>burin::ModelController</name>
    <message>
        <source>Importing %1</source>
        <translation>正在导入%1</translation>
    </message>
    <message>
        <source>%1: preview; the fine mesh is being made</source>
        <translation>%1：预览；正在生成精细网格</translation>
    </message>
    <message>
        <source>mirrored part</source>
        <translation>镜像零件</translation>
    </message>
    <message>
        <source>colour of bodies</source>
        <translation>实体的颜色</translation>
    </message>
</context>
<context>
    <name>burin::Notice</name>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
</context>
<context>
    <name>burin::ObstacleCard</name>
    <message>
        <source>waits until the tool is out</source>
        <translation>等待刀具离开</translation>
    </message>
    <message>
        <source>holds the tool</source>
        <translation>挡住刀具</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Distance that every point of the tool keeps from it</source>
        <translation>刀具上每一点与它保持的距离</translation>
    </message>
    <message>
        <source>Whether it keeps the tool out</source>
        <translation>是否将刀具挡在外面</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>删除它</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>夹具</translation>
    </message>
    <message>
        <source>Keep-out volume</source>
        <translation>禁入区</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>The corner with the lowest coordinates, from program zero</source>
        <translation>坐标最小的角点，相对程序零点</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Length of its edges</source>
        <translation>各边的长度</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>底面</translation>
    </message>
    <message>
        <source>The middle of its lower face, from program zero</source>
        <translation>下底面的中心，相对程序零点</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Of the cylinder</source>
        <translation>圆柱的直径</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>先停止录制。</translation>
    </message>
    <message>
        <source>%1 X, Y, Z, in %2</source>
        <translation>%1 X、Y、Z，单位 %2</translation>
    </message>
    <message>
        <source>A fixture is a solid object; a keep-out volume has to stay clear of the tool</source>
        <translation>夹具是实物；禁入区是刀具不得进入的空间</translation>
    </message>
    <message>
        <source>Change its sizes and its position</source>
        <translation>更改其尺寸和位置</translation>
    </message>
    <message>
        <source>From the library: %1</source>
        <translation>来自夹具库：%1</translation>
    </message>
    <message>
        <source>From a file, %1 triangles</source>
        <translation>来自文件，%1 个三角形</translation>
    </message>
    <message>
        <source>Move it in the view, with the mouse or the keys</source>
        <translation>在视图中用鼠标或按键移动</translation>
    </message>
</context>
<context>
    <name>burin::ObstacleMovePresenter</name>
    <message>
        <source>Drag the handles, click the stock or the table, or use the arrow keys, Page up and down; R rotates it. Enter keeps the new position, Esc the old one.</source>
        <translation>拖动手柄，单击毛坯或工作台，或使用方向键、Page Up 和 Page Down；R 键旋转。Enter 保留新位置，Esc 恢复原位置。</translation>
    </message>
    <message>
        <source>Drag the arrows, click the stock or the table, or use the arrow keys, Page up and down. R rotates it by 90°: the edges of a box stay parallel to the axes. Enter keeps the new position, Esc the old one.</source>
        <translation>拖动箭头，单击毛坯或工作台，或使用方向键、Page Up 和 Page Down。R 键旋转 90°：长方体的棱边始终平行于坐标轴。Enter 保留新位置，Esc 恢复原位置。</translation>
    </message>
</context>
<context>
    <name>burin::PartPanel</name>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Import a part…</source>
        <translation>导入零件…</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>Import another part…</source>
        <translation>导入另一个零件…</translation>
    </message>
    <message>
        <source>A part is being read.</source>
        <translation>正在读取零件。</translation>
    </message>
    <message>
        <source>The part is being read…</source>
        <translation>正在读取零件…</translation>
    </message>
    <message>
        <source>1 open edge</source>
        <translation>1 条开放边</translation>
    </message>
    <message numerus="yes">
        <source>%n open edges</source>
        <translation>
            <numerusform>%n条开放边</numerusform>
        </translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 个面</translation>
    </message>
    <message numerus="yes">
        <source>%n faces</source>
        <translation>
            <numerusform>%n个面</numerusform>
        </translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Healed</source>
        <translation>已修复</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>Import notes</source>
        <translation>导入说明</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>文件的单位</translation>
    </message>
    <message>
        <source>This is a preview. The fine mesh, which is milled to, is being made…</source>
        <translation>这是预览。正在生成铣削所用的精细网格…</translation>
    </message>
    <message>
        <source>Role of the selected body</source>
        <translation>所选实体的角色</translation>
    </message>
    <message>
        <source>The file states no unit. Choosing another one reads it again.</source>
        <translation>文件没有给出单位。选择其他单位会重新读取文件。</translation>
    </message>
    <message>
        <source>Read a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF)</source>
        <translation>读取 CAD 文件（STEP、IGES、BREP）或网格（STL、3MF、OBJ、PLY、AMF、OFF）</translation>
    </message>
    <message>
        <source>The CAD solid that is to be made. STEP keeps the exact surfaces, a mesh (STL, 3MF, OBJ) has only triangles.</source>
        <translation>要加工出的 CAD 实体。STEP 保留精确曲面，网格（STL、3MF、OBJ）只有三角形。</translation>
    </message>
    <message>
        <source>Size as stated</source>
        <translation>按注明单位的尺寸</translation>
    </message>
    <message>
        <source>Choosing another unit than the stated one reads the file again: the part gets another size.</source>
        <translation>选择与注明的不同的单位会重新读取文件：零件的尺寸随之改变。</translation>
    </message>
    <message>
        <source>Not imported</source>
        <translation>未导入</translation>
    </message>
</context>
<context>
    <name>burin::PassController</name>
    <message>
        <source>Computing the pass</source>
        <translation>正在计算走刀</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>正在读取程序</translation>
    </message>
</context>
<context>
    <name>burin::PassDialog</name>
    <message>
        <source>Compute a pass</source>
        <translation>计算走刀</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>不作任何更改</translation>
    </message>
    <message>
        <source>whole part</source>
        <translation>整个零件</translation>
    </message>
    <message>
        <source>from a drawing…</source>
        <translation>来自图纸…</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>strokes of take %1</source>
        <translation>录制%1的笔画</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>线条</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>图纸的单位</translation>
    </message>
    <message>
        <source>Enter the depth of the lines.</source>
        <translation>输入线条的深度。</translation>
    </message>
    <message>
        <source>Compute the pass in the background; it can be cancelled in the status line</source>
        <translation>在后台计算走刀；可在状态栏中取消</translation>
    </message>
    <message>
        <source>What the rows follow, or what is engraved: strokes of a recording or curves of a drawing</source>
        <translation>各行所跟随的线条，或要雕刻的内容：录制的笔画或图纸的曲线</translation>
    </message>
    <message>
        <source>as stated in the file</source>
        <translation>按文件所述</translation>
    </message>
    <message>
        <source>Unit of the coordinates; not every drawing states it</source>
        <translation>坐标的单位；并非每张图纸都给出</translation>
    </message>
    <message>
        <source>Choose the strokes or the drawing to engrave.</source>
        <translation>选择要雕刻的笔画或图纸。</translation>
    </message>
    <message>
        <source>Choose the strokes or the drawing that the rows follow.</source>
        <translation>选择各行所跟随的笔画或图纸。</translation>
    </message>
    <message>
        <source>painted area</source>
        <translation>涂画的区域</translation>
    </message>
    <message>
        <source>Where the tool may go: what was painted on the part, or the closed curves of a DXF or SVG drawing, in the coordinates of the setup</source>
        <translation>刀具可以到达的地方：在零件上涂画的区域，或 DXF、SVG 图纸中的封闭曲线，采用装夹的坐标</translation>
    </message>
    <message>
        <source>Area on the part</source>
        <translation>零件上的区域</translation>
    </message>
    <message>
        <source>The area limits where the tool touches the part, not where its tip goes</source>
        <translation>该区域限制刀具与零件接触的位置，而不是刀尖到达的位置</translation>
    </message>
    <message>
        <source>Paint the area of the pocket, or choose a drawing with its outline.</source>
        <translation>涂画型腔的区域，或选择含有其轮廓线的图纸。</translation>
    </message>
    <message>
        <source>Paint an area, or choose a drawing with the outline to follow.</source>
        <translation>涂画一个区域，或选择含有要跟随的轮廓线的图纸。</translation>
    </message>
    <message>
        <source>Change a pass</source>
        <translation>更改走刀</translation>
    </message>
    <message>
        <source>area of this pass</source>
        <translation>此走刀的区域</translation>
    </message>
    <message>
        <source>lines of this pass</source>
        <translation>此走刀的线条</translation>
    </message>
    <message>
        <source>Computes moves of %1 for the stock that the earlier paths leave, and adds them to the path of this tool. You can edit, check and undo them like recorded ones.</source>
        <translation>针对先前刀路留下的毛坯计算%1的移动，并添加到此刀具的刀路。它们可以像录制的移动一样编辑、检查和撤销。</translation>
    </message>
    <message>
        <source>Computes this pass of %1 again for the stock that is left before it. The pass keeps its position in the path.</source>
        <translation>针对此走刀之前留下的毛坯重新计算%1的此走刀。走刀在刀路中的位置不变。</translation>
    </message>
    <message>
        <source>The part has no round upright holes.</source>
        <translation>零件没有竖直的圆孔。</translation>
    </message>
    <message>
        <source>Upright holes of the part: %1</source>
        <translation>零件的竖直孔：%1</translation>
    </message>
    <message>
        <source>Pick holes…</source>
        <translation>选择孔…</translation>
    </message>
    <message>
        <source>All that fit</source>
        <translation>所有适合的孔</translation>
    </message>
    <message>
        <source>Choose a thread, or enter its pitch.</source>
        <translation>请选择螺纹，或输入螺距。</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Plays in the view how this pass is made: the stroke that leads it, the directions, then its rows one after the other. Changes nothing; Esc stops it</source>
        <translation>在视图中播放此走刀如何生成：引导它的笔画、方向，然后依次为各行。不做任何更改；按 Esc 停止</translation>
    </message>
    <message>
        <source>Stop showing</source>
        <translation>停止演示</translation>
    </message>
    <message>
        <source>Picked holes or studs</source>
        <translation>所选的孔或凸台</translation>
    </message>
    <message>
        <source>The holes or studs of this pass, in the coordinates of the setup; Del removes one</source>
        <translation>此走刀的孔或凸台，采用装夹坐标；按 Del 移除</translation>
    </message>
    <message>
        <source>Click holes of the part in the view, or studs for an external thread; a second click removes one</source>
        <translation>在视图中单击零件的孔，或单击凸台以铣外螺纹；再次单击则移除</translation>
    </message>
    <message>
        <source>Clear the selection: the pass uses every hole or stud of the part that fits</source>
        <translation>清除选择：走刀使用零件上所有适合的孔或凸台</translation>
    </message>
    <message>
        <source>The part has no round upright studs.</source>
        <translation>零件没有竖直的圆凸台。</translation>
    </message>
    <message>
        <source>Upright studs of the part: %1</source>
        <translation>零件的竖直凸台：%1</translation>
    </message>
    <message>
        <source>Enter the diameter of the thread, or pick its holes or studs.</source>
        <translation>请输入螺纹直径，或选择孔或凸台。</translation>
    </message>
</context>
<context>
    <name>burin::PassForm</name>
    <message>
        <source>Pass</source>
        <translation>走刀</translation>
    </message>
    <message>
        <source>What the pass does</source>
        <translation>走刀的用途</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Stock that stays on the part</source>
        <translation>零件上保留的毛坯厚度</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Distance between rows or loops, or between the heights of a waterline</source>
        <translation>各行或各圈之间的距离，或等高的高度间距</translation>
    </message>
    <message>
        <source>Scallop height</source>
        <translation>残留高度</translation>
    </message>
    <message>
        <source>Largest height of the ridges between rows; replaces the step-over. 0: not used</source>
        <translation>行间残脊的最大高度；代替行距。0：不使用</translation>
    </message>
    <message>
        <source>Depth of a level</source>
        <translation>每层切深</translation>
    </message>
    <message>
        <source>Largest depth of a level. Default: what material, tool and spindle can take</source>
        <translation>每层的最大深度。默认：材料、刀具和主轴所能承受的值</translation>
    </message>
    <message>
        <source>Depth of a peck</source>
        <translation>每次啄钻深度</translation>
    </message>
    <message>
        <source>The drill comes up for its chips after each peck. 0: in one go up to three diameters, one diameter at a time in deeper holes</source>
        <translation>每次啄钻后钻头上升排屑。0：不超过三倍直径时一次钻到底，更深的孔每次钻一倍直径</translation>
    </message>
    <message>
        <source>Steps on slopes</source>
        <translation>斜面台阶</translation>
    </message>
    <message>
        <source>Largest height of the steps that the levels leave on slopes</source>
        <translation>分层在斜面上留下的台阶的最大高度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Depth of the lines below the top of the stock</source>
        <translation>线条在毛坯顶面以下的深度</translation>
    </message>
    <message>
        <source>Depth of the tip below the top of the stock. 0: to the bottom of each hole of the part</source>
        <translation>刀尖在毛坯顶面以下的深度。0：到零件各孔的底部</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Angle between the rows and X</source>
        <translation>各行与 X 的夹角</translation>
    </message>
    <message>
        <source>Steeper than</source>
        <translation>最小陡度</translation>
    </message>
    <message>
        <source>Only where the part is at least this steep</source>
        <translation>仅在零件的陡度不小于此值处</translation>
    </message>
    <message>
        <source>Flatter than</source>
        <translation>最大陡度</translation>
    </message>
    <message>
        <source>Only where the part is at most this steep</source>
        <translation>仅在零件的陡度不大于此值处</translation>
    </message>
    <message>
        <source>From height</source>
        <translation>起始高度</translation>
    </message>
    <message>
        <source>Height at which the pass begins, in the coordinates of the setup</source>
        <translation>走刀开始的高度，采用装夹的坐标</translation>
    </message>
    <message>
        <source>Down to height</source>
        <translation>终止高度</translation>
    </message>
    <message>
        <source>Lowest height of the tip, in the coordinates of the setup</source>
        <translation>刀尖的最低高度，采用装夹的坐标</translation>
    </message>
    <message>
        <source>Holding tabs</source>
        <translation>连接片</translation>
    </message>
    <message>
        <source>How many bridges stay on each outline</source>
        <translation>每条轮廓线上保留的连接片数量</translation>
    </message>
    <message>
        <source>Width of a tab</source>
        <translation>连接片宽度</translation>
    </message>
    <message>
        <source>Along the outline</source>
        <translation>沿轮廓线</translation>
    </message>
    <message>
        <source>Height of a tab</source>
        <translation>连接片高度</translation>
    </message>
    <message>
        <source>Above the lowest level of the pass</source>
        <translation>走刀最低一层以上</translation>
    </message>
    <message>
        <source>Only where stock is left</source>
        <translation>仅在有残料处</translation>
    </message>
    <message>
        <source>Skips rows that would touch no stock</source>
        <translation>跳过不会接触毛坯的行</translation>
    </message>
    <message>
        <source>All rows in one direction</source>
        <translation>所有行同一方向</translation>
    </message>
    <message>
        <source>The tool returns through the air after each row</source>
        <translation>每行之后刀具空中返回</translation>
    </message>
    <message>
        <source>Inside the outline</source>
        <translation>轮廓线内侧</translation>
    </message>
    <message>
        <source>The cutter follows the outline of the area on its inside</source>
        <translation>铣刀沿区域轮廓线的内侧移动</translation>
    </message>
    <message>
        <source>Dogbones</source>
        <translation>狗骨清角</translation>
    </message>
    <message>
        <source>Cuts into the inner corners of the area, so that a part with square corners fits</source>
        <translation>切入区域的内角，使直角零件能够装入</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>螺距</translation>
    </message>
    <message>
        <source>Distance between neighbouring crests of the thread; 25.4 mm divided by the threads per inch</source>
        <translation>相邻牙顶之间的距离；等于 25.4 mm 除以每英寸牙数</translation>
    </message>
    <message>
        <source>Major diameter</source>
        <translation>大径</translation>
    </message>
    <message>
        <source>other thread</source>
        <translation>其他螺纹</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>螺纹</translation>
    </message>
    <message>
        <source>Metric thread of coarse pitch, ISO 261</source>
        <translation>公制粗牙螺纹，ISO 261</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>走刀次数</translation>
    </message>
    <message>
        <source>Spring pass</source>
        <translation>光刀走刀</translation>
    </message>
    <message>
        <source>Follows the thread once more at full depth</source>
        <translation>以全深再沿螺纹走一遍</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>左旋</translation>
    </message>
    <message>
        <source>Left-handed instead of right-handed thread</source>
        <translation>左旋螺纹而非右旋螺纹</translation>
    </message>
    <message>
        <source>Conventional milling</source>
        <translation>逆铣</translation>
    </message>
    <message>
        <source>Number of passes along the thread, each deeper than the one before</source>
        <translation>沿螺纹走刀的次数，逐次加深</translation>
    </message>
    <message>
        <source>Hand strokes</source>
        <translation>手动笔画</translation>
    </message>
    <message>
        <source>What the rows do where strokes of the hand, earlier in this path, have finished the part. Keep off: cut nothing there. Blend: go on over the border by the overlap, without a step. Extend: the rows of a flow continue these strokes sideways</source>
        <translation>此刀路中在前的手动笔画已精加工零件之处各行如何处理。避开：不在那里切削。融合：越过边界一段重叠量，不留台阶。延续：流线的各行向两侧延续这些笔画</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重叠量</translation>
    </message>
    <message>
        <source>How far rows go on over the border of what the hand has finished</source>
        <translation>各行越过手动已精加工区域边界的距离</translation>
    </message>
    <message>
        <source>Finished within</source>
        <translation>精加工允差</translation>
    </message>
    <message>
        <source>Largest height that the hand may have left on what counts as finished</source>
        <translation>视为已精加工之处手动可留下的最大高度</translation>
    </message>
    <message>
        <source>ignore</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>keep off</source>
        <translation>避开</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>融合</translation>
    </message>
    <message>
        <source>extend</source>
        <translation>延续</translation>
    </message>
    <message>
        <source>Of the thread. The part&apos;s holes must be modelled with this diameter, its studs with the minor diameter that the mill cuts. 0: as each picked hole or stud has it</source>
        <translation>螺纹的大径。零件的孔须按此直径建模，凸台须按铣刀所铣的小径建模。0：由每个所选的孔或凸台得出</translation>
    </message>
    <message>
        <source>Length of the thread below the top of its hole or stud. 0: as far as each hole is open and drilled, or as the tool has room around the stud</source>
        <translation>螺纹自孔口或凸台顶面向下的长度。0：到每个孔贯通且已钻到的深度，或到刀具在凸台周围有空间之处</translation>
    </message>
    <message>
        <source>External thread</source>
        <translation>外螺纹</translation>
    </message>
    <message>
        <source>On round studs of the part instead of in its holes; picking holes or studs in the view sets it</source>
        <translation>在零件的圆凸台上，而非孔内；在视图中选择孔或凸台时自动设置</translation>
    </message>
    <message>
        <source>Conventional instead of climb milling: internal right-hand threads are cut from the top down, external ones from the bottom up</source>
        <translation>逆铣而非顺铣：内右旋螺纹自上而下铣削，外右旋螺纹自下而上铣削</translation>
    </message>
</context>
<context>
    <name>burin::PassMeasurer</name>
    <message>
        <source>Measuring the passes</source>
        <translation>正在测量走刀</translation>
    </message>
</context>
<context>
    <name>burin::PassPreviewer</name>
    <message>
        <source>Preparing the preview</source>
        <translation>正在准备预览</translation>
    </message>
    <message>
        <source>Computing the preview</source>
        <translation>正在计算预览</translation>
    </message>
</context>
<context>
    <name>burin::PassRefresher</name>
    <message>
        <source>Looking for passes that are out of date</source>
        <translation>正在查找过时的走刀</translation>
    </message>
    <message>
        <source>Computing the passes that are out of date</source>
        <translation>正在计算过时的走刀</translation>
    </message>
</context>
<context>
    <name>burin::PathColours</name>
    <message>
        <source>Kind of move</source>
        <translation>移动类型</translation>
    </message>
</context>
<context>
    <name>burin::PathComparer</name>
    <message>
        <source>Comparing paths</source>
        <translation>正在比较刀路</translation>
    </message>
</context>
<context>
    <name>burin::PathController</name>
    <message>
        <source>change of an edit</source>
        <translation>更改编辑步骤</translation>
    </message>
    <message>
        <source>new edit</source>
        <translation>新建编辑步骤</translation>
    </message>
    <message>
        <source>point of the path</source>
        <translation>刀路的点</translation>
    </message>
    <message>
        <source>drawn stroke</source>
        <translation>绘制的笔画</translation>
    </message>
    <message>
        <source>deletion of an edit</source>
        <translation>删除编辑步骤</translation>
    </message>
    <message>
        <source>order of edits</source>
        <translation>编辑步骤的顺序</translation>
    </message>
    <message>
        <source>new path</source>
        <translation>新建刀路</translation>
    </message>
    <message>
        <source>computed pass</source>
        <translation>计算的走刀</translation>
    </message>
    <message>
        <source>deletion of a pass</source>
        <translation>删除走刀</translation>
    </message>
    <message>
        <source>order of passes</source>
        <translation>走刀的顺序</translation>
    </message>
    <message>
        <source>path of a program</source>
        <translation>程序的刀路</translation>
    </message>
    <message>
        <source>take in the path</source>
        <translation>将录制加入刀路</translation>
    </message>
    <message>
        <source>take out of the path</source>
        <translation>从刀路中移出录制</translation>
    </message>
    <message>
        <source>inserted point</source>
        <translation>插入的点</translation>
    </message>
    <message>
        <source>passes computed again</source>
        <translation>重新计算的走刀</translation>
    </message>
</context>
<context>
    <name>burin::PathHand</name>
    <message>
        <source>Esc: cancel</source>
        <translation>Esc：取消</translation>
    </message>
    <message>
        <source>Esc: cancel drawing</source>
        <translation>Esc：取消绘制</translation>
    </message>
    <message>
        <source>Esc: clear the selection</source>
        <translation>Esc：清除选择</translation>
    </message>
</context>
<context>
    <name>burin::PathPanel</name>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>切削长度</translation>
    </message>
    <message>
        <source>Error of all edits</source>
        <translation>所有编辑步骤的误差</translation>
    </message>
    <message>
        <source>Edits, in order</source>
        <translation>编辑步骤（按顺序）</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>刀路</translation>
    </message>
    <message>
        <source>Show the path in the view</source>
        <translation>在视图中显示刀路</translation>
    </message>
    <message>
        <source>New path from the takes</source>
        <translation>由录制新建刀路</translation>
    </message>
    <message>
        <source>Update path</source>
        <translation>更新刀路</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>正在处理。</translation>
    </message>
    <message>
        <source>The path is up to date.</source>
        <translation>刀路已是最新。</translation>
    </message>
    <message>
        <source>Apply the edits again</source>
        <translation>重新应用编辑步骤</translation>
    </message>
    <message>
        <source>The edits are being applied…</source>
        <translation>正在应用编辑步骤…</translation>
    </message>
    <message>
        <source>Takes or edits changed: update the path.</source>
        <translation>录制或编辑步骤已更改：更新刀路。</translation>
    </message>
    <message>
        <source>Largest deviation of the path from the recording</source>
        <translation>刀路与录制的最大偏差</translation>
    </message>
    <message>
        <source>The workpiece is being made; then the edits are applied…</source>
        <translation>正在生成工件；之后应用编辑步骤…</translation>
    </message>
    <message>
        <source>Add an edit</source>
        <translation>添加编辑步骤</translation>
    </message>
    <message>
        <source>Adds an edit, at the position that the order of edits allows</source>
        <translation>添加编辑步骤，位置由编辑步骤的顺序决定</translation>
    </message>
    <message>
        <source>Climb / conventional</source>
        <translation>顺铣 / 逆铣</translation>
    </message>
    <message>
        <source>The path of %1, which is milled before, can&apos;t be made. Its stock counts as not removed here; load that tool to see why.</source>
        <translation>无法生成先行铣削的%1的刀路。其毛坯在此按未去除计算；装载该刀具可查看原因。</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>笔画</translation>
    </message>
    <message>
        <source>Order and position</source>
        <translation>顺序和位置</translation>
    </message>
    <message>
        <source>Drawn by hand</source>
        <translation>手工绘制</translation>
    </message>
    <message>
        <source>Smoother, fewer moves</source>
        <translation>平滑并减少移动</translation>
    </message>
    <message>
        <source>Against the part</source>
        <translation>对照零件</translation>
    </message>
    <message>
        <source>Leads and links</source>
        <translation>切入切出和连接</translation>
    </message>
    <message>
        <source>Feeds and speed</source>
        <translation>进给和转速</translation>
    </message>
    <message>
        <source>Make a path of all takes, one for each tool, with the standard edits</source>
        <translation>由所有录制生成刀路，每把刀具一条，带标准编辑步骤</translation>
    </message>
    <message>
        <source>Loads the tool whose path is shown and edited, one of those that have milled</source>
        <translation>装载要显示和编辑其刀路的刀具，从已铣削过的刀具中选择</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>With a spindle that rotates clockwise; conventional cuts are pink in the view. Other moves cut on both sides, or from above. Reverse changes the direction of strokes</source>
        <translation>按主轴顺时针旋转；逆铣在视图中显示为粉色。其他移动在两侧切削，或从上方切削。“反向”可改变笔画的方向</translation>
    </message>
    <message>
        <source>Takes and passes</source>
        <translation>录制和走刀</translation>
    </message>
    <message>
        <source>Compute a pass…</source>
        <translation>计算走刀…</translation>
    </message>
    <message>
        <source>Record a take first, or compute a pass.</source>
        <translation>先录制，或计算走刀。</translation>
    </message>
    <message>
        <source>%1 has not milled yet. Choose a tool that has, record a take, or compute a pass.</source>
        <translation>%1还没有铣削过。选择已铣削过的刀具、进行录制，或计算走刀。</translation>
    </message>
    <message>
        <source>Delete this pass</source>
        <translation>删除此走刀</translation>
    </message>
    <message>
        <source>Wait until the workpiece is ready and no pass is being computed.</source>
        <translation>等待工件就绪且没有走刀正在计算。</translation>
    </message>
    <message>
        <source>Change this pass and compute it again</source>
        <translation>更改此走刀并重新计算</translation>
    </message>
    <message>
        <source>%1 of the pass were skipped: too much stock is in the way of the tool. Rough it first, or use a longer tool.</source>
        <translation>走刀中有%1被跳过：挡住刀具的毛坯太多。先粗加工，或使用更长的刀具。</translation>
    </message>
    <message>
        <source>%1 of the pass were skipped: fixtures or keep-out volumes are in the way.</source>
        <translation>走刀中有%1被跳过：夹具或禁入区挡住了去路。</translation>
    </message>
    <message>
        <source>Measure the passes</source>
        <translation>测量走刀</translation>
    </message>
    <message>
        <source>Wait until the path is up to date and measured.</source>
        <translation>等待刀路更新并测量完毕。</translation>
    </message>
    <message>
        <source>Length, time, share of air and engagement of each pass, and the stock that it leaves</source>
        <translation>每次走刀的长度、时间、空切比例和吃刀量，以及留下的毛坯</translation>
    </message>
    <message>
        <source>Mill this pass before the one above</source>
        <translation>将此走刀移到上方走刀之前铣削</translation>
    </message>
    <message>
        <source>Compute roughing, finishing, a pocket, a profile, drilling, threads or engraving with the loaded tool</source>
        <translation>用当前刀具计算粗加工、精加工、型腔、轮廓、钻孔、螺纹或雕刻</translation>
    </message>
    <message>
        <source>The loaded tool doesn&apos;t turn: it has no passes.</source>
        <translation>当前刀具不旋转：没有走刀。</translation>
    </message>
    <message>
        <source>Compute outdated passes again</source>
        <translation>重新计算过时的走刀</translation>
    </message>
    <message>
        <source>Compute those passes again whose strokes have changed; all others stay as they are</source>
        <translation>重新计算笔画已改变的走刀；其他走刀保持不变</translation>
    </message>
    <message>
        <source>Out of date: hand strokes that this pass depends on have changed.</source>
        <translation>已过时：此走刀所依赖的手动笔画已更改。</translation>
    </message>
</context>
<context>
    <name>burin::PathPresenter</name>
    <message>
        <source>Preview: nothing is left to do there.</source>
        <translation>预览：那里已没有可加工的内容。</translation>
    </message>
    <message>
        <source>Preview: about %1 of cutting, %2 without links.</source>
        <translation>预览：切削约%1，不含连接%2。</translation>
    </message>
    <message>
        <source>One row in %1 is drawn.</source>
        <translation>每 %1 行刀路只绘制一行。</translation>
    </message>
    <message>
        <source>%1 in %2, %3 % in air; engagement within %4° for 95 % of the cut, at most %5°.</source>
        <translation>%1，用时%2，空切 %3 %；95 % 的切削中接触角不超过 %4°，最大 %5°。</translation>
    </message>
    <message>
        <source>Stock left on 99 % of the reachable part: at most %1 (most: %2).</source>
        <translation>可到达的零件表面中 99 % 的残料不超过%1（最大：%2）。</translation>
    </message>
    <message>
        <source>%1 are skipped: already finished by hand strokes.</source>
        <translation>已跳过 %1：手动笔画已精加工完毕。</translation>
    </message>
</context>
<context>
    <name>burin::PathScenePresenter</name>
    <message>
        <source>&amp;Insert a point here</source>
        <translation>在此处插入点(&amp;I)</translation>
    </message>
    <message>
        <source>Insert a point into the path here. Drag it to move it; the stroke follows it smoothly.</source>
        <translation>在刀路此处插入一点。拖动可移动它；笔画平滑地跟随。</translation>
    </message>
    <message>
        <source>Show this &amp;moment</source>
        <translation>显示此时刻(&amp;M)</translation>
    </message>
    <message>
        <source>Go to the time on the timeline at which this point was milled.</source>
        <translation>转到时间轴上铣削该点的时间。</translation>
    </message>
    <message>
        <source>Computed point</source>
        <translation>计算得出的点</translation>
    </message>
    <message>
        <source>Esc: leave the point where it was</source>
        <translation>Esc：让该点留在原处</translation>
    </message>
    <message>
        <source>Esc: put the stylus down</source>
        <translation>Esc：放下触笔</translation>
    </message>
</context>
<context>
    <name>burin::PathValuer</name>
    <message>
        <source>Colouring the path</source>
        <translation>正在为刀路着色</translation>
    </message>
</context>
<context>
    <name>burin::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Colours of the window.</source>
        <translation>窗口的颜色。</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Takes effect at the next start.</source>
        <translation>下次启动时生效。</translation>
    </message>
    <message>
        <source>A new language takes effect at the next start.</source>
        <translation>新语言在下次启动时生效。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The unit in which lengths are shown. Files always hold millimetres.</source>
        <translation>长度的显示单位。文件始终以毫米保存。</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>与系统相同</translation>
    </message>
    <message>
        <source>Close this window.</source>
        <translation>关闭此窗口。</translation>
    </message>
</context>
<context>
    <name>burin::PresetTable</name>
    <message>
        <source>Add a preset</source>
        <translation>添加预设</translation>
    </message>
    <message>
        <source>Feeds and speeds for one material, or for any</source>
        <translation>针对一种材料或任意材料的进给和转速</translation>
    </message>
    <message>
        <source>any material</source>
        <translation>任意材料</translation>
    </message>
    <message>
        <source>%1 (not available)</source>
        <translation>%1（不可用）</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Material of the stock that the preset is for</source>
        <translation>预设适用的毛坯材料</translation>
    </message>
    <message>
        <source>by material</source>
        <translation>按材料</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>mist</source>
        <translation>喷雾</translation>
    </message>
    <message>
        <source>flood</source>
        <translation>浇注</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>冷却液</translation>
    </message>
    <message>
        <source>Coolant that paths with this preset use</source>
        <translation>使用此预设的刀路所用的冷却方式</translation>
    </message>
    <message>
        <source>Prefer preset %1 to the one before it</source>
        <translation>预设 %1 优先于前一个</translation>
    </message>
    <message>
        <source>Delete preset %1</source>
        <translation>删除预设 %1</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>0: by the feed per tooth</source>
        <translation>0：按每齿进给量</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>每齿进给量</translation>
    </message>
    <message>
        <source>0: by the feed</source>
        <translation>0：按进给</translation>
    </message>
    <message>
        <source>Plunge feed</source>
        <translation>下刀进给</translation>
    </message>
    <message>
        <source>0: the share of the feed that the material states</source>
        <translation>0：材料给出的进给比例</translation>
    </message>
    <message>
        <source>Step-down</source>
        <translation>每层切深</translation>
    </message>
    <message>
        <source>Depth of a level, at most the deepest cut. 0: what material, tool and spindle can take</source>
        <translation>每层的切深，至多为最大切深。0：材料、刀具和主轴所能承受的值</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Between the loops of a level, at most half the diameter. 0: a share of the diameter</source>
        <translation>同层各圈之间的距离，至多为直径的一半。0：直径的一定比例</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Name of the preset, different from those of the tool&apos;s other presets</source>
        <translation>预设的名称，不同于该刀具的其他预设</translation>
    </message>
    <message>
        <source>Speed of the spindle at which the feed applies</source>
        <translation>进给所对应的主轴转速</translation>
    </message>
</context>
<context>
    <name>burin::ProgramController</name>
    <message>
        <source>Posting and checking</source>
        <translation>正在后处理和检查</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>正在检查</translation>
    </message>
    <message>
        <source>text of the program</source>
        <translation>程序文本</translation>
    </message>
    <message>
        <source>Making and checking the rest of the program</source>
        <translation>正在生成并检查程序的其余部分</translation>
    </message>
</context>
<context>
    <name>burin::ProgramDock</name>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Put text and findings back into the panel</source>
        <translation>将文本和问题放回面板</translation>
    </message>
</context>
<context>
    <name>burin::ProgramEditor</name>
    <message>
        <source>Check the edited text</source>
        <translation>检查编辑后的文本</translation>
    </message>
    <message>
        <source>Findings of the check</source>
        <translation>检查发现的问题</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>正在处理。</translation>
    </message>
    <message>
        <source>Read the edited text back and mill it again on a fresh workpiece</source>
        <translation>读回编辑后的文本，并在新的工件上重新铣削</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第%1行</translation>
    </message>
    <message>
        <source>program</source>
        <translation>程序</translation>
    </message>
</context>
<context>
    <name>burin::ProgramPanel</name>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Post and check</source>
        <translation>后处理并检查</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Gouge tolerance</source>
        <translation>过切公差</translation>
    </message>
    <message>
        <source>Deepest gouge that passes the check</source>
        <translation>检查允许通过的最大过切深度</translation>
    </message>
    <message>
        <source>Deepest gouge</source>
        <translation>最大过切</translation>
    </message>
    <message>
        <source>On the part</source>
        <translation>贴合零件</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>去除量</translation>
    </message>
    <message>
        <source>Machining time</source>
        <translation>加工时间</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>程序段</translation>
    </message>
    <message>
        <source>Post the path first.</source>
        <translation>先对刀路做后处理。</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>正在处理。</translation>
    </message>
    <message>
        <source>The program did not pass its check.</source>
        <translation>程序未通过检查。</translation>
    </message>
    <message>
        <source>Not passed: 1 finding.</source>
        <translation>未通过：1 个问题。</translation>
    </message>
    <message numerus="yes">
        <source>Not passed: %n findings.</source>
        <translation>
            <numerusform>未通过：%n 个问题。</numerusform>
        </translation>
    </message>
    <message>
        <source>The program is being posted and checked…</source>
        <translation>正在后处理和检查程序…</translation>
    </message>
    <message>
        <source>Make a path first.</source>
        <translation>先生成刀路。</translation>
    </message>
    <message>
        <source>Passed: gouge %1 (limit %2), no collision, all limits kept.</source>
        <translation>通过：过切%1（限值%2），无碰撞，所有限值均满足。</translation>
    </message>
    <message>
        <source>Judged on the exact surfaces at the worst points</source>
        <translation>在最差的点处按精确曲面判定</translation>
    </message>
    <message>
        <source>Judged on the fine mesh</source>
        <translation>按精细网格判定</translation>
    </message>
    <message>
        <source>Write the program, read it back and mill it again on a fresh workpiece</source>
        <translation>写出程序，读回，并在新的工件上重新铣削</translation>
    </message>
    <message>
        <source>Write the program to a file for the machine</source>
        <translation>将机床用的程序写入文件</translation>
    </message>
    <message>
        <source>Excess, mean / max</source>
        <translation>残料，平均 / 最大</translation>
    </message>
    <message>
        <source>Override the check…</source>
        <translation>忽略检查结果…</translation>
    </message>
    <message>
        <source>Give a reason that goes into the program&apos;s header; then it can be exported</source>
        <translation>填写理由并写入程序头，之后即可导出</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Its feeds, speeds and travel limit the program</source>
        <translation>程序受其进给、转速和行程限制</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>方言</translation>
    </message>
    <message>
        <source>NC dialect that the machine&apos;s control reads</source>
        <translation>机床控制系统读取的 NC 方言</translation>
    </message>
    <message>
        <source>The text was edited: check it first.</source>
        <translation>文本已编辑：先检查。</translation>
    </message>
    <message>
        <source>The reason for exporting it is stated in its header.</source>
        <translation>导出的理由写在程序头中。</translation>
    </message>
    <message>
        <source>mm (G21)</source>
        <translation>mm (G21)</translation>
    </message>
    <message>
        <source>inch (G20)</source>
        <translation>英寸 (G20)</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Lengths and feeds in the program&apos;s text</source>
        <translation>程序文本中的长度和进给</translation>
    </message>
    <message>
        <source>Tools of the program</source>
        <translation>程序的刀具</translation>
    </message>
    <message>
        <source>Whether the program contains the path of this tool</source>
        <translation>程序是否包含此刀具的刀路</translation>
    </message>
    <message>
        <source>The takes of %1 have no path and are not in the program. Make a new path to include them.</source>
        <translation>%1的录制没有刀路，不在程序中。要包含它们，需生成新刀路。</translation>
    </message>
    <message>
        <source>Takes or edits changed: update the path first.</source>
        <translation>录制或编辑步骤有改动：先更新刀路。</translation>
    </message>
    <message>
        <source>The program is not checked yet: post and check it.</source>
        <translation>程序尚未检查：先做后处理并检查。</translation>
    </message>
    <message>
        <source>The path or its check&apos;s inputs have changed. Post and check again.</source>
        <translation>刀路或其检查所用的数据有改动。重新后处理并检查。</translation>
    </message>
    <message>
        <source>Out of date: passed its check before the last changes.</source>
        <translation>已过期：在最近的改动之前通过了检查。</translation>
    </message>
    <message>
        <source>Out of date: failed its check before the last changes.</source>
        <translation>已过期：在最近的改动之前未通过检查。</translation>
    </message>
    <message>
        <source>On the part: the share of the cutting moves over the part in which the cutter is within %1 of its surface. Close to 100 % for finishing, low for roughing.</source>
        <translation>贴合零件：在零件上方的切削移动中，刀具距零件表面不超过%1的移动所占的比例。精加工时接近 100 %，粗加工时较低。</translation>
    </message>
    <message>
        <source>no path</source>
        <translation>无刀路</translation>
    </message>
    <message>
        <source>Post and check again.</source>
        <translation>重新后处理并检查。</translation>
    </message>
    <message>
        <source>Machines…</source>
        <translation>机床…</translation>
    </message>
    <message>
        <source>Look at the machines; copy, change and delete your own</source>
        <translation>查看机床；复制、修改和删除自己的机床</translation>
    </message>
    <message>
        <source>The project&apos;s machine “%1” is not on this computer; “%2” is used in its place.</source>
        <translation>项目的机床“%1”不在这台计算机上；改用“%2”。</translation>
    </message>
    <message>
        <source>Typical values, not those of your machine: copy it and enter yours.</source>
        <translation>这是典型值，不是你的机床的数值：复制后填入自己的数值。</translation>
    </message>
    <message>
        <source>Your own machine.</source>
        <translation>自有机床。</translation>
    </message>
    <message>
        <source>With accelerations, corners, dwells and 1 tool change; %1 at the programmed feeds alone</source>
        <translation>包含加减速、拐角、暂停和 1 次换刀；仅按编程进给计算为%1</translation>
    </message>
    <message numerus="yes">
        <source>With accelerations, corners, dwells and %n tool changes; %1 at the programmed feeds alone</source>
        <translation>
            <numerusform>包含加减速、拐角、暂停和 %n 次换刀；仅按编程进给计算为%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Excess tolerance</source>
        <translation>残料公差</translation>
    </message>
    <message>
        <source>Largest difference allowed between the stock left on the part and what the paths leave, and largest excess at blended corners; 0: not judged</source>
        <translation>零件上的残料与刀路应留余量之间允许的最大差值，以及过渡拐角处允许的最大残料；0：不判定</translation>
    </message>
    <message numerus="yes">
        <source>Without moves whose start the program does not state (approach, return): %n</source>
        <translation>
            <numerusform>不含程序未给出起点的移动（接近、返回）：%n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>burin::ProgramScenePresenter</name>
    <message>
        <source>rapid</source>
        <translation>快速移动</translation>
    </message>
    <message>
        <source>waits %1 s</source>
        <translation>暂停 %1 s</translation>
    </message>
    <message>
        <source>feed %1 %2/min</source>
        <translation>进给 %1 %2/min</translation>
    </message>
    <message>
        <source>spindle %1/min</source>
        <translation>主轴 %1/min</translation>
    </message>
    <message>
        <source>spindle off</source>
        <translation>主轴停止</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>the hand: %1</source>
        <translation>手：%1</translation>
    </message>
    <message>
        <source>%1 N, peak %2 N</source>
        <translation>%1 N，峰值 %2 N</translation>
    </message>
    <message>
        <source>peak %1 W</source>
        <translation>峰值 %1 W</translation>
    </message>
</context>
<context>
    <name>burin::ProgramText</name>
    <message>
        <source>Edit the program&apos;s text</source>
        <translation>编辑程序文本</translation>
    </message>
    <message>
        <source>Previous match (Shift+Enter)</source>
        <translation>上一个匹配项（Shift+Enter）</translation>
    </message>
    <message>
        <source>Next match (Enter)</source>
        <translation>下一个匹配项（Enter）</translation>
    </message>
    <message>
        <source>Find in the program</source>
        <translation>在程序中查找</translation>
    </message>
    <message>
        <source>Text to find, upper or lower case; Enter goes to the next match, Shift+Enter to the previous one</source>
        <translation>要查找的文本，不区分大小写；Enter 跳到下一个匹配项，Shift+Enter 跳到上一个</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>程序文本</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Number of matches</source>
        <translation>匹配项数量</translation>
    </message>
    <message>
        <source>The text can&apos;t be changed yet: press this button to edit it</source>
        <translation>文本还不能修改：按此按钮开始编辑</translation>
    </message>
</context>
<context>
    <name>burin::ProgramView</name>
    <message>
        <source>Click a line&apos;s number to stop a play there</source>
        <translation>单击行号，播放到该行时停止</translation>
    </message>
</context>
<context>
    <name>burin::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
</context>
<context>
    <name>burin::QuantityField</name>
    <message>
        <source>%1 is out of range (%2 to %3). The value stays at %4.</source>
        <translation>%1超出范围（%2 到 %3）。数值仍为 %4。</translation>
    </message>
</context>
<context>
    <name>burin::RoleLabels</name>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>嵌件</translation>
    </message>
    <message>
        <source>Protected insert</source>
        <translation>受保护的嵌件</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>夹具</translation>
    </message>
    <message>
        <source>Ignored</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>A part and a protected insert are not cut; an insert is cut and has a material of its own; a fixture holds the stock; stock is what the part is cut from</source>
        <translation>零件和受保护的嵌件不切削；嵌件会被切削，并有自己的材料；夹具固定毛坯；毛坯是用来切出零件的材料</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>圆柱体</translation>
    </message>
    <message>
        <source>Bodies of the model</source>
        <translation>模型的实体</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>来自文件</translation>
    </message>
</context>
<context>
    <name>burin::ScoreController</name>
    <message>
        <source>Scoring</source>
        <translation>正在评分</translation>
    </message>
</context>
<context>
    <name>burin::ScoreDialog</name>
    <message>
        <source>Score</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>The take that is scored</source>
        <translation>被评分的录制</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>The take to compare it with, such as a teacher&apos;s; it may be switched off</source>
        <translation>用于比较的录制，例如师傅的录制；可以是已停用的</translation>
    </message>
    <message>
        <source>Draw the reference on the timeline</source>
        <translation>在时间轴上绘制参考录制</translation>
    </message>
    <message>
        <source>Its curves are drawn as thin lines behind those of the take, from the take&apos;s start</source>
        <translation>其曲线从该录制的起点开始，以细线画在该录制的曲线后面</translation>
    </message>
    <message>
        <source>Progress of the scoring.</source>
        <translation>评分进度。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop scoring</source>
        <translation>停止评分</translation>
    </message>
    <message>
        <source>Scoring was cancelled; choose a take to start it again.</source>
        <translation>评分已取消；请选择一段录制以重新开始。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>No reference</source>
        <translation>无参考</translation>
    </message>
</context>
<context>
    <name>burin::SegmentTable</name>
    <message>
        <source>Add a segment</source>
        <translation>添加一段</translation>
    </message>
    <message>
        <source>On top, as wide as the one below</source>
        <translation>加在顶部，与下面一段同宽</translation>
    </message>
    <message>
        <source>Segment %1, diameter below</source>
        <translation>第 %1 段，下端直径</translation>
    </message>
    <message>
        <source>Segment %1, diameter above</source>
        <translation>第 %1 段，上端直径</translation>
    </message>
    <message>
        <source>Segment %1, length</source>
        <translation>第 %1 段，长度</translation>
    </message>
    <message>
        <source>Delete segment %1</source>
        <translation>删除第 %1 段</translation>
    </message>
</context>
<context>
    <name>burin::SelectionCard</name>
    <message>
        <source>Clear the selection (Esc in the view)</source>
        <translation>清除选择（在视图中按 Esc）</translation>
    </message>
    <message>
        <source>Draw instead</source>
        <translation>改为手绘</translation>
    </message>
    <message>
        <source>Click a point of the path in the view to select it; Shift+click selects everything up to it</source>
        <translation>在视图中单击刀路上的点将其选中；Shift+单击则选中到该点为止的全部</translation>
    </message>
    <message>
        <source>on its level</source>
        <translation>在其高度上</translation>
    </message>
    <message>
        <source>Z, the tool&apos;s axis</source>
        <translation>Z，即刀轴</translation>
    </message>
    <message>
        <source>the part&apos;s surface</source>
        <translation>零件表面</translation>
    </message>
    <message>
        <source>Drag along</source>
        <translation>拖动方向</translation>
    </message>
    <message>
        <source>How a dragged point of the path moves</source>
        <translation>拖动刀路上的点时，点如何移动</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>已选：%1</translation>
    </message>
    <message>
        <source>No part of the path is selected</source>
        <translation>未选中刀路的任何部分</translation>
    </message>
    <message>
        <source>Select part of the path in the view first.</source>
        <translation>先在视图中选择一段刀路。</translation>
    </message>
    <message>
        <source>Draw a stroke in the view that replaces the selected part of the path, at its height</source>
        <translation>在视图中绘制一个笔画，在所选刀路段的高度上替换该段</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>顺铣</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>逆铣</translation>
    </message>
    <message>
        <source>Draw it in the view; Esc cancels</source>
        <translation>在视图中绘制；Esc 取消</translation>
    </message>
    <message>
        <source>Timeline: not in this path</source>
        <translation>时间轴：不在此刀路中</translation>
    </message>
    <message>
        <source>The path has no point that was milled at %1</source>
        <translation>刀路中没有在此时刻铣削的点：%1</translation>
    </message>
    <message>
        <source>Timeline: X %1, Y %2, Z %3</source>
        <translation>时间轴：X %1，Y %2，Z %3</translation>
    </message>
    <message>
        <source>Point of the path at the time on the timeline, from program zero: %1</source>
        <translation>时间轴所示时间的刀路点，从程序零点算起：%1</translation>
    </message>
    <message>
        <source>Edit with the stylus</source>
        <translation>用触笔编辑</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>作用范围</translation>
    </message>
    <message>
        <source>Distance from the tool&apos;s tip within which a device takes the nearest point of the path</source>
        <translation>设备可抓取最近刀路点的范围：到刀尖的距离</translation>
    </message>
    <message>
        <source>Move points of the path with the chosen stylus, and feel part and fixtures meanwhile</source>
        <translation>用所选的触笔移动刀路上的点，同时感受零件和夹具</translation>
    </message>
</context>
<context>
    <name>burin::SetupController</name>
    <message>
        <source>voxel size</source>
        <translation>体素尺寸</translation>
    </message>
    <message>
        <source>stock margin</source>
        <translation>毛坯余量</translation>
    </message>
    <message>
        <source>stock material</source>
        <translation>毛坯材料</translation>
    </message>
    <message>
        <source>material of a body</source>
        <translation>实体的材料</translation>
    </message>
    <message>
        <source>free carving</source>
        <translation>自由雕刻</translation>
    </message>
    <message>
        <source>shape of the stock</source>
        <translation>毛坯形状</translation>
    </message>
    <message>
        <source>role of a body</source>
        <translation>实体的角色</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>材料层</translation>
    </message>
    <message>
        <source>Reading the stock from %1</source>
        <translation>正在从%1读取毛坯</translation>
    </message>
    <message>
        <source>Rotating the stock</source>
        <translation>正在旋转毛坯</translation>
    </message>
    <message>
        <source>placement of the part</source>
        <translation>零件的放置</translation>
    </message>
    <message>
        <source>program zero</source>
        <translation>程序零点</translation>
    </message>
    <message>
        <source>Examining the face</source>
        <translation>正在分析该面</translation>
    </message>
    <message>
        <source>role of bodies</source>
        <translation>多个实体的角色</translation>
    </message>
</context>
<context>
    <name>burin::SetupPanel</name>
    <message>
        <source>Placement</source>
        <translation>放置</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>装夹</translation>
    </message>
    <message>
        <source>The current setup. Each setup has its own stock, fixtures, recordings, paths and programs</source>
        <translation>当前装夹。每个装夹都有自己的毛坯、夹具、录制、刀路和程序</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of this setup, shown in lists and in the file name of its program</source>
        <translation>此装夹的名称，显示在列表和其程序的文件名中</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>添加…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Update the stock</source>
        <translation>更新毛坯</translation>
    </message>
    <message>
        <source>Face down</source>
        <translation>面朝下</translation>
    </message>
    <message>
        <source>Face up</source>
        <translation>面朝上</translation>
    </message>
    <message>
        <source>Along X</source>
        <translation>沿 X</translation>
    </message>
    <message>
        <source>Along Y</source>
        <translation>沿 Y</translation>
    </message>
    <message>
        <source>90° %1</source>
        <translation>90° %1</translation>
    </message>
    <message>
        <source>Rotation axis</source>
        <translation>旋转轴</translation>
    </message>
    <message>
        <source>Axis of the rotation below; it passes through the centre of the part</source>
        <translation>下方旋转所绕的轴；它通过零件中心</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>旋转角度</translation>
    </message>
    <message>
        <source>Rotates the part by this angle. Positive: counter-clockwise, seen from the tip of the axis</source>
        <translation>将零件旋转此角度。正值：从轴的顶端看为逆时针</translation>
    </message>
    <message>
        <source>Lower corner %1</source>
        <translation>下角点 %1</translation>
    </message>
    <message>
        <source>Lower corner of the part&apos;s bounding box. A new value moves the part</source>
        <translation>零件包围盒的下角点。输入新值会移动零件</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>镜像 %1</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>先导入零件。</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>正在处理。</translation>
    </message>
    <message>
        <source>Embed the part first: the next setup starts with the workpiece of this one.</source>
        <translation>先嵌入零件：下一个装夹从此装夹的工件开始。</translation>
    </message>
    <message>
        <source>Add a setup for another side of the part. Its stock is the workpiece that this setup leaves</source>
        <translation>添加一个装夹，加工零件的另一面。其毛坯是此装夹留下的工件</translation>
    </message>
    <message>
        <source>A job needs at least one setup.</source>
        <translation>一项加工至少需要一个装夹。</translation>
    </message>
    <message>
        <source>Delete this setup. Only a setup without recordings, paths and programs can be deleted</source>
        <translation>删除此装夹。只有没有录制、刀路和程序的装夹才能删除</translation>
    </message>
    <message>
        <source>The setup that this stock comes from has changed. The stock is not up to date.</source>
        <translation>此毛坯来源的装夹有改动。毛坯不是最新的。</translation>
    </message>
    <message>
        <source>Delete the recordings of this setup first.</source>
        <translation>先删除此装夹的录制。</translation>
    </message>
    <message>
        <source>Replay the setup that this stock comes from, and use its workpiece</source>
        <translation>重新铣削此毛坯来源的装夹，并使用其工件</translation>
    </message>
    <message>
        <source>This setup has recordings. Add a setup to rotate the part.</source>
        <translation>此装夹已有录制。要旋转零件，需添加装夹。</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points down. A cylinder or cone: so that its axis is vertical</source>
        <translation>单击一个面：旋转零件，使该面朝下。圆柱面或圆锥面：使其轴线竖直</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points up. A cylinder or cone: so that its axis is vertical</source>
        <translation>单击一个面：旋转零件，使该面朝上。圆柱面或圆锥面：使其轴线竖直</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points along X. A cylinder or cone: so that its axis is parallel to X</source>
        <translation>单击一个面：旋转零件，使该面朝向 X。圆柱面或圆锥面：使其轴线平行于 X</translation>
    </message>
    <message>
        <source>Click a face: the part is rotated so that it points along Y. A cylinder or cone: so that its axis is parallel to Y</source>
        <translation>单击一个面：旋转零件，使该面朝向 Y。圆柱面或圆锥面：使其轴线平行于 Y</translation>
    </message>
    <message>
        <source>Click a face of the part in the view.</source>
        <translation>在视图中单击零件的一个面。</translation>
    </message>
    <message>
        <source>Rotate the part by 90° about %1, through its centre</source>
        <translation>将零件绕%1旋转 90°，旋转轴通过零件中心</translation>
    </message>
    <message>
        <source>A part with several setups can&apos;t be mirrored.</source>
        <translation>有多个装夹的零件不能镜像。</translation>
    </message>
    <message>
        <source>Mirror the part across %1. It is then another part than the one in the file</source>
        <translation>将零件沿%1镜像。此后它与文件中的零件不再相同</translation>
    </message>
</context>
<context>
    <name>burin::SetupsController</name>
    <message>
        <source>Preparing the stock</source>
        <translation>正在准备毛坯</translation>
    </message>
    <message>
        <source>Setup %1</source>
        <translation>装夹 %1</translation>
    </message>
    <message>
        <source>further setup</source>
        <translation>新装夹</translation>
    </message>
    <message>
        <source>name of a setup</source>
        <translation>装夹的名称</translation>
    </message>
    <message>
        <source>deletion of a setup</source>
        <translation>删除装夹</translation>
    </message>
    <message>
        <source>stock of another setup</source>
        <translation>来自另一装夹的毛坯</translation>
    </message>
</context>
<context>
    <name>burin::SetupsPresenter</name>
    <message>
        <source>Setup %1</source>
        <translation>装夹 %1</translation>
    </message>
    <message>
        <source>This face is curved and has no direction. Click a plane, a cylinder or a cone.</source>
        <translation>此面是曲面，没有方向。单击平面、圆柱面或圆锥面。</translation>
    </message>
</context>
<context>
    <name>burin::SheetController</name>
    <message>
        <source>Preparing the setup sheet</source>
        <translation>正在准备装夹单</translation>
    </message>
</context>
<context>
    <name>burin::SheetText</name>
    <message>
        <source>Project %1, %2</source>
        <translation>项目 %1，%2</translation>
    </message>
    <message>
        <source>Setup sheet: %1</source>
        <translation>装夹单：%1</translation>
    </message>
    <message>
        <source>Setup sheet: %1, setup %2</source>
        <translation>装夹单：%1，装夹 %2</translation>
    </message>
    <message>
        <source>There is no checked program for this setup yet.</source>
        <translation>此装夹还没有检查过的程序。</translation>
    </message>
    <message>
        <source>The setup has changed since the program was checked. Check it again.</source>
        <translation>程序检查之后装夹有改动。重新检查程序。</translation>
    </message>
    <message>
        <source>The program failed its check and was exported with a reason. See below.</source>
        <translation>程序未通过检查，已附理由导出。见下文。</translation>
    </message>
    <message>
        <source>The program failed its check. Do not run it.</source>
        <translation>程序未通过检查。不要运行。</translation>
    </message>
    <message>
        <source>Stock with the part, as clamped</source>
        <translation>装夹状态下的毛坯与零件</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Machine and zero</source>
        <translation>机床与零点</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制系统</translation>
    </message>
    <message>
        <source>Units of the program</source>
        <translation>程序的单位</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>工件偏置</translation>
    </message>
    <message>
        <source>Program zero</source>
        <translation>程序零点</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>刀轴</translation>
    </message>
    <message>
        <source>free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Round bar</source>
        <translation>圆棒料</translation>
    </message>
    <message>
        <source>diameter %1, length %2</source>
        <translation>直径%1，长度%2</translation>
    </message>
    <message>
        <source>Comes from</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>setup %1</source>
        <translation>装夹%1</translation>
    </message>
    <message>
        <source>, %1 g</source>
        <translation>，%1 g</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Fixtures and keep-out volumes</source>
        <translation>夹具和禁入区</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>无。</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>夹具</translation>
    </message>
    <message>
        <source>keep out</source>
        <translation>禁入区</translation>
    </message>
    <message>
        <source>%1, off</source>
        <translation>%1，已停用</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>尚无。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>刃部</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>伸出长度</translation>
    </message>
    <message>
        <source>Speed, 1/min</source>
        <translation>转速，1/min</translation>
    </message>
    <message>
        <source>Feed, in/min</source>
        <translation>进给，in/min</translation>
    </message>
    <message>
        <source>Feed, mm/min</source>
        <translation>进给，mm/min</translation>
    </message>
    <message>
        <source>Lowest Z, %1</source>
        <translation>最低 Z，%1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>failed, exported with a reason</source>
        <translation>未通过，已附理由导出</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>%1 (tolerance %2)</source>
        <translation>%1（公差%2）</translation>
    </message>
    <message>
        <source>Machining time</source>
        <translation>加工时间</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>程序段</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>The check found nothing.</source>
        <translation>检查未发现问题。</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>检测结果</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>flutes %1</source>
        <translation>刃部 %1</translation>
    </message>
    <message>
        <source>stick-out %1</source>
        <translation>伸出长度 %1</translation>
    </message>
    <message>
        <source>Maximum gouge</source>
        <translation>最大过切</translation>
    </message>
    <message>
        <source>From zero to the stock: left, front, bottom</source>
        <translation>从零点到毛坯：左、前、底</translation>
    </message>
    <message>
        <source>From zero to the stock: right, back, top</source>
        <translation>从零点到毛坯：右、后、顶</translation>
    </message>
</context>
<context>
    <name>burin::ShortcutDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>&amp;Assign</source>
        <translation>分配(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation>重置(&amp;S)</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Show only actions whose name, tooltip or shortcut contains this.</source>
        <translation>只显示名称、提示或快捷键中包含此内容的命令。</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>命令及其快捷键</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>新快捷键</translation>
    </message>
    <message>
        <source>Click here and press the new shortcut.</source>
        <translation>单击此处，然后按下新快捷键。</translation>
    </message>
    <message>
        <source>Assign this shortcut to the selected action.</source>
        <translation>将此快捷键分配给所选命令。</translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action.</source>
        <translation>移除所选命令的快捷键。</translation>
    </message>
    <message>
        <source>Reset the shortcut of the selected action to its default.</source>
        <translation>将所选命令的快捷键恢复为默认。</translation>
    </message>
    <message>
        <source>Reset the shortcuts of all actions to their defaults.</source>
        <translation>将所有命令的快捷键恢复为默认。</translation>
    </message>
    <message>
        <source>“%1” has this shortcut and would lose it.</source>
        <translation>“%1”已使用此快捷键，分配后将失去它。</translation>
    </message>
</context>
<context>
    <name>burin::ShowMe</name>
    <message>
        <source>Planning the strokes</source>
        <translation>正在规划笔画</translation>
    </message>
</context>
<context>
    <name>burin::StatusLine</name>
    <message>
        <source>Stylus that moves the tool.</source>
        <translation>移动刀具的触笔。</translation>
    </message>
    <message>
        <source>Position of the tool tip, in the coordinates of the program.</source>
        <translation>刀尖的位置，以程序坐标表示。</translation>
    </message>
    <message>
        <source>Whether all changes are saved in the project file.</source>
        <translation>所有改动是否已保存到项目文件。</translation>
    </message>
    <message>
        <source>Work in the background.</source>
        <translation>后台任务。</translation>
    </message>
    <message>
        <source>Progress of the work in the background.</source>
        <translation>后台任务的进度。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop the work in the background.</source>
        <translation>停止后台任务。</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>正在停止</translation>
    </message>
    <message>
        <source>Haptic loop: ticks per second; interval between two forces and computing time of a tick, neither of which 999 of 1000 exceed; ticks missed.</source>
        <translation>力反馈循环：每秒周期数；两次力输出的间隔和一个周期的计算时间（1000 次中有 999 次不超过所示值）；错过的周期数。</translation>
    </message>
    <message>
        <source>Everything that is cut is recorded in this take.</source>
        <translation>所有切削都记入此录制。</translation>
    </message>
    <message>
        <source>Effect of the Escape key.</source>
        <translation>Esc 键的作用。</translation>
    </message>
    <message>
        <source>Voxels of the workpiece, the memory reserved for it, and a hash of it: the same recordings and settings give the same hash.</source>
        <translation>工件的体素、为其预留的内存及其哈希值：相同的录制和设置得到相同的哈希值。</translation>
    </message>
</context>
<context>
    <name>burin::StatusPresenter</name>
    <message>
        <source>Read only</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>尚未保存</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Saved just now</source>
        <translation>刚刚已保存</translation>
    </message>
    <message>
        <source>Saved at %1</source>
        <translation>已于 %1 保存</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels · %4 MB</source>
        <translation>%1 × %2 × %3 体素 · %4 MB</translation>
    </message>
    <message>
        <source>Saved 1 minute ago</source>
        <translation>1 分钟前已保存</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n minutes ago</source>
        <translation>
            <numerusform>%n 分钟前已保存</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Hz · p99.9 %2 ms, work %3 µs · %4 missed</source>
        <translation>%1 Hz · p99.9 %2 ms，计算 %3 µs · 错过 %4</translation>
    </message>
    <message>
        <source>battery %1</source>
        <translation>电池 %1</translation>
    </message>
    <message>
        <source>motors %1</source>
        <translation>电机 %1</translation>
    </message>
    <message>
        <source>● Recording %1</source>
        <translation>● 正在录制 %1</translation>
    </message>
    <message>
        <source>hash %1</source>
        <translation>哈希值%1</translation>
    </message>
</context>
<context>
    <name>burin::StepBar</name>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Mill</source>
        <translation>铣削</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>刀路</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
</context>
<context>
    <name>burin::StepButton</name>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>can be done</source>
        <translation>可进行</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>有问题</translation>
    </message>
</context>
<context>
    <name>burin::StockPanel</name>
    <message>
        <source>Margin, sides</source>
        <translation>侧面余量</translation>
    </message>
    <message>
        <source>Stock beside the part, on all four sides</source>
        <translation>零件四周的毛坯材料，四个侧面相同</translation>
    </message>
    <message>
        <source>Margin, top</source>
        <translation>顶部余量</translation>
    </message>
    <message>
        <source>Stock above the part</source>
        <translation>零件上方的毛坯材料</translation>
    </message>
    <message>
        <source>Margin, bottom</source>
        <translation>底部余量</translation>
    </message>
    <message>
        <source>Stock below the part</source>
        <translation>零件下方的毛坯材料</translation>
    </message>
    <message>
        <source>Stock size</source>
        <translation>毛坯尺寸</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>体素尺寸</translation>
    </message>
    <message>
        <source>Smaller voxels show finer detail and take more memory</source>
        <translation>体素越小，细节越精细，占用内存越多</translation>
    </message>
    <message>
        <source>Embed the part</source>
        <translation>嵌入零件</translation>
    </message>
    <message>
        <source>%1&#xa0;million</source>
        <translation>%1 百万</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels = %4, %5&#xa0;MB</source>
        <translation>%1 × %2 × %3 体素 = %4，%5 MB</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>先导入零件。</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>正在处理。</translation>
    </message>
    <message>
        <source>Stock and material can&apos;t be changed once there are takes.</source>
        <translation>有录制之后，毛坯和材料不能再更改。</translation>
    </message>
    <message>
        <source>The margins of the sides differ: %1 to %2. An entry sets all four.</source>
        <translation>各侧面的余量不同：%1 到 %2。输入一个值将同时设定四个侧面。</translation>
    </message>
    <message>
        <source>Embedded</source>
        <translation>已嵌入</translation>
    </message>
    <message>
        <source>Embed the part in its stock; this makes the workpiece</source>
        <translation>将零件嵌入毛坯，由此生成工件</translation>
    </message>
    <message>
        <source>The workpiece matches these settings.</source>
        <translation>工件与这些设置一致。</translation>
    </message>
    <message>
        <source>The workpiece matches these settings; after a change of stock or voxels it has to be embedded again.</source>
        <translation>工件与这些设置一致；毛坯或体素改动后须重新嵌入。</translation>
    </message>
    <message>
        <source>Embedding has 1 finding. See the end of this page.</source>
        <translation>嵌入有 1 个问题。见本页末尾。</translation>
    </message>
    <message numerus="yes">
        <source>Embedding has %n findings. See the end of this page.</source>
        <translation>
            <numerusform>嵌入有 %n 个问题。见本页末尾。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>毛坯</translation>
    </message>
</context>
<context>
    <name>burin::StockShapeFields</name>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴线</translation>
    </message>
    <message>
        <source>Direction that the axis of the cylinder lies in</source>
        <translation>圆柱体轴线所在的方向</translation>
    </message>
    <message>
        <source>On: the stock is where it is stated, whatever the part. Off: it lies around the part, with margins</source>
        <translation>开：毛坯位于给定的位置，与零件无关。关：毛坯围绕零件，带余量</translation>
    </message>
    <message>
        <source>On: no part is needed. Where there is none nothing pushes the tool back</source>
        <translation>开：不需要零件。没有零件的地方，没有力把刀具推回</translation>
    </message>
    <message>
        <source>In the model&apos;s frame</source>
        <translation>在模型坐标系中</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>终止 %1</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>起始 %1</translation>
    </message>
    <message>
        <source>Middle of its end, %1</source>
        <translation>端面中心，%1</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Another direction</source>
        <translation>其他方向</translation>
    </message>
    <message>
        <source>At a stated place</source>
        <translation>在给定的位置</translation>
    </message>
    <message>
        <source>Free carving</source>
        <translation>自由雕刻</translation>
    </message>
    <message>
        <source>A box, a round bar, the bodies of the model whose role is stock, or what a file holds</source>
        <translation>长方体、圆棒料、模型中角色为毛坯的实体，或文件的内容</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Read the stock from another volume file, voxel array (a scan) or model</source>
        <translation>从另一个体积文件、体素阵列（扫描数据）或模型读取毛坯</translation>
    </message>
</context>
<context>
    <name>burin::StockSolidController</name>
    <message>
        <source>Preparing the stock for fixtures</source>
        <translation>正在为夹具准备毛坯</translation>
    </message>
    <message>
        <source>Fitting the fixture to the stock</source>
        <translation>正在使夹具贴合毛坯</translation>
    </message>
</context>
<context>
    <name>burin::StylusController</name>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Connecting %1</source>
        <translation>正在连接%1</translation>
    </message>
</context>
<context>
    <name>burin::StylusEditPresenter</name>
    <message>
        <source>Drag a point of the path: the tool goes with it, along part, fixtures and travel.</source>
        <translation>拖动刀路上的一点：刀具随之移动，并受零件、夹具和行程限制。</translation>
    </message>
    <message>
        <source>Move the tool to the path, hold the device&apos;s first button to take the nearest point within reach, and let go where it is to be.</source>
        <translation>将刀具移到刀路处，按住设备的第一个按钮抓取范围内最近的点，移到目标位置后松开按钮。</translation>
    </message>
    <message>
        <source>Wait until the path is up to date.</source>
        <translation>请等待刀路更新完成。</translation>
    </message>
    <message>
        <source>The point is moved by %1</source>
        <translation>该点移动了 %1</translation>
    </message>
    <message>
        <source>Drag a point of the path in the view</source>
        <translation>在视图中拖动刀路上的一点</translation>
    </message>
    <message>
        <source>A point is in reach, at %1</source>
        <translation>范围内有一个点，距离 %1</translation>
    </message>
    <message>
        <source>No point is in reach</source>
        <translation>范围内没有点</translation>
    </message>
    <message>
        <source>Leave mill mode first.</source>
        <translation>请先退出铣削模式。</translation>
    </message>
    <message>
        <source>Wait until the workpiece and the boundary are ready.</source>
        <translation>请等待工件和边界准备就绪。</translation>
    </message>
    <message>
        <source>Make a path first.</source>
        <translation>请先创建刀路。</translation>
    </message>
</context>
<context>
    <name>burin::StylusEditor</name>
    <message>
        <source>“%1” has no button that could take a point of the path. Choose another device, or drag the point with the mouse.</source>
        <translation>“%1”没有可用来抓取刀路点的按钮。请选择其他设备，或用鼠标拖动该点。</translation>
    </message>
</context>
<context>
    <name>burin::SurroundingsController</name>
    <message>
        <source>Keep-out %1</source>
        <translation>禁入区 %1</translation>
    </message>
    <message>
        <source>Fixture %1</source>
        <translation>夹具 %1</translation>
    </message>
    <message>
        <source>new fixture</source>
        <translation>新建夹具</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>正在导入%1</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>夹具</translation>
    </message>
    <message>
        <source>fixture deleted</source>
        <translation>删除夹具</translation>
    </message>
    <message>
        <source>fixture on</source>
        <translation>启用夹具</translation>
    </message>
    <message>
        <source>fixture off</source>
        <translation>停用夹具</translation>
    </message>
    <message>
        <source>tool axis</source>
        <translation>刀轴</translation>
    </message>
    <message>
        <source>machine&apos;s travel</source>
        <translation>机床行程</translation>
    </message>
    <message>
        <source>fixture renamed</source>
        <translation>重命名夹具</translation>
    </message>
    <message>
        <source>fixture moved</source>
        <translation>移动夹具</translation>
    </message>
</context>
<context>
    <name>burin::SurroundingsPanel</name>
    <message>
        <source>Fixtures and keep-out volumes</source>
        <translation>夹具和禁入区</translation>
    </message>
    <message>
        <source>There is no fixture yet. The tool keeps clear of fixtures and keep-out volumes, and the hand feels them.</source>
        <translation>还没有夹具。刀具会避开夹具和禁入区，手也能感觉到它们。</translation>
    </message>
    <message>
        <source>Machine&apos;s travel</source>
        <translation>机床行程</translation>
    </message>
    <message>
        <source>Kind of fixture or keep-out volume to add</source>
        <translation>要添加的夹具或禁入区的类型</translation>
    </message>
    <message>
        <source>Fixture: box</source>
        <translation>夹具：长方体</translation>
    </message>
    <message>
        <source>Fixture: cylinder</source>
        <translation>夹具：圆柱体</translation>
    </message>
    <message>
        <source>Fixture from a file…</source>
        <translation>来自文件的夹具…</translation>
    </message>
    <message>
        <source>Keep out: box</source>
        <translation>禁入区：长方体</translation>
    </message>
    <message>
        <source>Keep out: cylinder</source>
        <translation>禁入区：圆柱体</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>刀轴</translation>
    </message>
    <message>
        <source>fixed, Z</source>
        <translation>固定，Z</translation>
    </message>
    <message>
        <source>chosen, 3+2</source>
        <translation>指定，3+2</translation>
    </message>
    <message>
        <source>free, with the hand</source>
        <translation>自由，随手</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴线</translation>
    </message>
    <message>
        <source>Whether the tool axis is fixed, chosen or free</source>
        <translation>刀轴是固定、指定还是自由</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>倾角</translation>
    </message>
    <message>
        <source>Angle between the tool axis and Z</source>
        <translation>刀轴与 Z 之间的角度</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Where the holder leans to: 0° is X, 90° is Y</source>
        <translation>刀柄倾斜的方向：0° 为 X，90° 为 Y</translation>
    </message>
    <message>
        <source>Along the view</source>
        <translation>沿视图方向</translation>
    </message>
    <message>
        <source>Stop the recording first.</source>
        <translation>先停止录制。</translation>
    </message>
    <message>
        <source>Sets the tool axis to the view direction (3+2 milling)</source>
        <translation>将刀轴设为视图方向（3+2 铣削）</translation>
    </message>
    <message>
        <source>Import a part first.</source>
        <translation>先导入零件。</translation>
    </message>
    <message>
        <source>Work is under way.</source>
        <translation>正在处理。</translation>
    </message>
    <message>
        <source>The machine&apos;s travel limits a vertical tool only.</source>
        <translation>机床行程只限制竖直的刀具。</translation>
    </message>
    <message>
        <source>The tool tip stays within the travel of the machine&apos;s axes</source>
        <translation>刀尖保持在机床各轴的行程内</translation>
    </message>
    <message>
        <source>Puts it next to the stock, or at the coordinates of its file. An STL file has the unit of the part&apos;s STL file, else mm.</source>
        <translation>放在毛坯旁边，或放在其文件的坐标处。STL 文件采用零件 STL 文件的单位，否则为 mm。</translation>
    </message>
    <message>
        <source>Kind to add</source>
        <translation>要添加的类型</translation>
    </message>
    <message>
        <source>Fixture from the library…</source>
        <translation>来自夹具库的夹具…</translation>
    </message>
</context>
<context>
    <name>burin::TakeDeviations</name>
    <message>
        <source>Computing the deviation of the takes</source>
        <translation>正在计算录制的偏差</translation>
    </message>
</context>
<context>
    <name>burin::TakeList</name>
    <message>
        <source>1 stroke</source>
        <translation>1 个笔画</translation>
    </message>
    <message>
        <source>being replayed</source>
        <translation>正在重放</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n 个笔画</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 个采样点</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>不完整</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>正在录制</translation>
    </message>
    <message>
        <source>Delete this take</source>
        <translation>删除此录制</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>已损坏</translation>
    </message>
</context>
<context>
    <name>burin::TargetController</name>
    <message>
        <source>machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>方言</translation>
    </message>
    <message>
        <source>units of the program</source>
        <translation>程序的单位</translation>
    </message>
    <message>
        <source>copy of a machine</source>
        <translation>复制机床</translation>
    </message>
    <message>
        <source>values of a machine</source>
        <translation>机床的数值</translation>
    </message>
    <message>
        <source>deleting a machine</source>
        <translation>删除机床</translation>
    </message>
</context>
<context>
    <name>burin::TimeController</name>
    <message>
        <source>switch on</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>switch off</source>
        <translation>停用</translation>
    </message>
    <message>
        <source>punch in</source>
        <translation>插录</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>delete a marker</source>
        <translation>删除标记</translation>
    </message>
    <message>
        <source>Reading the program&apos;s time</source>
        <translation>正在读取程序的时间</translation>
    </message>
    <message>
        <source>Computing the workpiece at that time</source>
        <translation>正在计算该时刻的工件</translation>
    </message>
    <message>
        <source>Storing the workpiece</source>
        <translation>正在存储工件</translation>
    </message>
</context>
<context>
    <name>burin::TimePresenter</name>
    <message>
        <source>Recording</source>
        <translation>正在录制</translation>
    </message>
</context>
<context>
    <name>burin::TimelinePanel</name>
    <message>
        <source>Cutting force on the tool.</source>
        <translation>刀具所受的切削力。</translation>
    </message>
    <message>
        <source>Volume removed per time.</source>
        <translation>单位时间去除的体积。</translation>
    </message>
    <message>
        <source>Z of the tip in the setup&apos;s coordinates.</source>
        <translation>刀尖的 Z，以装夹坐标表示。</translation>
    </message>
    <message>
        <source>¼ ×</source>
        <translation>¼ ×</translation>
    </message>
    <message>
        <source>½ ×</source>
        <translation>½ ×</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>到开头</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>到末尾</translation>
    </message>
    <message>
        <source>Reading the takes…</source>
        <translation>正在读取录制…</translation>
    </message>
    <message>
        <source>Distance by which the part, a fixture or a guide held the hand back.</source>
        <translation>手被零件、夹具或导向挡回的距离。</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>Playback speed, as a multiple of real time.</source>
        <translation>播放速度，实时速度的倍数。</translation>
    </message>
    <message>
        <source>Speed of the tool tip.</source>
        <translation>刀尖的速度。</translation>
    </message>
    <message>
        <source>Cross-section of the cut: volume removed per distance moved.</source>
        <translation>切削的横截面：单位移动距离去除的体积。</translation>
    </message>
    <message>
        <source>Select the curves to draw.</source>
        <translation>选择要绘制的曲线。</translation>
    </message>
    <message>
        <source>Distance of the tool from the part; negative: the tool is in the part. Distances above 5 mm are drawn as 5 mm.</source>
        <translation>刀具到零件的距离；负值：刀具进入零件。大于 5 mm 的距离按 5 mm 绘制。</translation>
    </message>
</context>
<context>
    <name>burin::TimelineView</name>
    <message>
        <source>Timeline of the takes</source>
        <translation>录制的时间轴</translation>
    </message>
    <message>
        <source>Left and right arrow keys move through the time, Space plays, plus and minus zoom.</source>
        <translation>左右方向键沿时间移动，空格键播放，加号和减号缩放。</translation>
    </message>
    <message>
        <source>Takes appear here once something was milled.</source>
        <translation>铣削之后，录制会显示在这里。</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>到 %1</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The program&apos;s time is being read.</source>
        <translation>正在读取程序的时间。</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Click or drag to go to that time. Mouse wheel: zoom; with Shift: scroll.</source>
        <translation>单击或拖动可转到该时刻。鼠标滚轮：缩放；按住 Shift：滚动。</translation>
    </message>
    <message>
        <source>%1: %2, reference: %3</source>
        <translation>%1：%2，参考：%3</translation>
    </message>
    <message>
        <source>The selected point was computed: no take has it</source>
        <translation>所选的点是计算得出的：没有录制包含它</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>lowest and highest value</comment>
        <translation>%1 到 %2</translation>
    </message>
</context>
<context>
    <name>burin::ToolController</name>
    <message>
        <source>tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Making a tool of %1</source>
        <translation>正在由%1生成刀具</translation>
    </message>
    <message>
        <source>new tool</source>
        <translation>新建刀具</translation>
    </message>
    <message>
        <source>copy of a tool</source>
        <translation>复制刀具</translation>
    </message>
    <message>
        <source>values of a tool</source>
        <translation>刀具的数值</translation>
    </message>
    <message>
        <source>deleting a tool</source>
        <translation>删除刀具</translation>
    </message>
    <message>
        <source>import of tools</source>
        <translation>导入刀具</translation>
    </message>
    <message>
        <source>new tool library</source>
        <translation>新建刀具库</translation>
    </message>
    <message>
        <source>moving a tool to another library</source>
        <translation>将刀具移到另一个刀具库</translation>
    </message>
    <message>
        <source>name of a tool library</source>
        <translation>刀具库的名称</translation>
    </message>
    <message>
        <source>deleting a tool library</source>
        <translation>删除刀具库</translation>
    </message>
</context>
<context>
    <name>burin::ToolDialog</name>
    <message>
        <source>Tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>shipped</source>
        <translation>自带</translation>
    </message>
    <message>
        <source>Copy this tool to one of your own and change that</source>
        <translation>将此刀具复制为自己的刀具，再修改</translation>
    </message>
    <message>
        <source>Delete this tool; Undo brings it back (Del in the list)</source>
        <translation>删除此刀具；撤销可恢复（在列表中按 Del）</translation>
    </message>
    <message>
        <source>The tools that Burin is shipped with can&apos;t be deleted.</source>
        <translation>Burin 自带的刀具不能删除。</translation>
    </message>
    <message>
        <source>There is a tool with the ID “%1” already; give the one in the file another ID.</source>
        <translation>已有 ID 为“%1”的刀具；给文件中的刀具换一个 ID。</translation>
    </message>
    <message>
        <source>The open project has recordings with this tool and keeps the values that they were made with.</source>
        <translation>打开的项目中有用此刀具做的录制，录制保留当时所用的数值。</translation>
    </message>
    <message>
        <source>Burin is shipped with this tool, which can&apos;t be changed. Copy it and enter the values of your own.</source>
        <translation>此刀具是 Burin 自带的，不能修改。复制它，再填入自己刀具的数值。</translation>
    </message>
    <message>
        <source>Your own tool.</source>
        <translation>自己的刀具。</translation>
    </message>
    <message>
        <source>It is in the spindle.</source>
        <translation>它在主轴上。</translation>
    </message>
    <message>
        <source>Mill with this tool (Ctrl+Return)</source>
        <translation>用此刀具铣削（Ctrl+Return）</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1（副本）</translation>
    </message>
    <message>
        <source>Add a tool file, or a tool bit of FreeCAD (.fctb)</source>
        <translation>添加刀具文件或 FreeCAD 的刀具文件（.fctb）</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Written to “%1”.</source>
        <translation>已写入“%1”。</translation>
    </message>
    <message>
        <source>Load into the spindle</source>
        <translation>装入主轴</translation>
    </message>
    <message>
        <source>A recording is running; end it first.</source>
        <translation>正在录制；先结束录制。</translation>
    </message>
    <message>
        <source>Check the stick-out, holder and limits of each tool; other programs may not store them.</source>
        <translation>检查每把刀具的伸出长度、刀柄和限值；其他程序可能不保存这些数据。</translation>
    </message>
    <message>
        <source>Move or copy to…</source>
        <translation>移动或复制到…</translation>
    </message>
    <message>
        <source>Put this tool, or a copy of it, into another library</source>
        <translation>把此刀具或其副本放入另一个刀具库</translation>
    </message>
    <message>
        <source>Write this tool for FreeCAD (.fctb), or the listed library for FreeCAD (.fctl), LinuxCNC (.tbl), Fusion (.tools) or CAMotics (.ctbl)</source>
        <translation>将此刀具写出供 FreeCAD 使用（.fctb），或将列出的刀具库写出供 FreeCAD（.fctl）、LinuxCNC（.tbl）、Fusion（.tools）或 CAMotics（.ctbl）使用</translation>
    </message>
    <message>
        <source>This library is empty. Copy or move tools into it, or add them from a file.</source>
        <translation>此刀具库为空。请复制或移入刀具，或从文件添加。</translation>
    </message>
    <message>
        <source>A preset has no name; enter one.</source>
        <translation>有一个预设没有名称；请输入名称。</translation>
    </message>
    <message>
        <source>Two presets are called “%1”; rename one of them.</source>
        <translation>有两个预设名为“%1”；请重命名其中一个。</translation>
    </message>
    <message>
        <source>The preset “%1” needs a speed, and a feed or a feed per tooth.</source>
        <translation>预设“%1”需要转速，以及进给或每齿进给量。</translation>
    </message>
    <message>
        <source>Your own tool, in the library “%1”.</source>
        <translation>您自己的刀具，在刀具库“%1”中。</translation>
    </message>
    <message>
        <source>Move to “%1”</source>
        <translation>移动到“%1”</translation>
    </message>
    <message>
        <source>Copy to “%1”</source>
        <translation>复制到“%1”</translation>
    </message>
    <message>
        <source>Copy to a new library…</source>
        <translation>复制到新刀具库…</translation>
    </message>
    <message>
        <source>This library is empty: there is nothing to export.</source>
        <translation>此刀具库为空：没有可导出的内容。</translation>
    </message>
    <message numerus="yes">
        <source>%n tools were added to the library “%1”.</source>
        <translation>
            <numerusform>已在刀具库“%1”中添加 %n 把刀具。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>burin::ToolDrawing</name>
    <message>
        <source>Drawing of the tool, to scale</source>
        <translation>刀具图，按比例绘制</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>刀尖</translation>
    </message>
    <message>
        <source>Flutes %1</source>
        <translation>刃部 %1</translation>
    </message>
    <message>
        <source>Stick-out %1</source>
        <translation>伸出长度 %1</translation>
    </message>
    <message>
        <source>Overall %1</source>
        <translation>总长 %1</translation>
    </message>
</context>
<context>
    <name>burin::ToolForm</name>
    <message>
        <source>as stated in the tool&apos;s source</source>
        <translation>按刀具来源中的说明</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name in the list of tools</source>
        <translation>刀具列表中的名称</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>T in programs</source>
        <translation>程序中的 T 号</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Source of the values that have none of their own</source>
        <translation>没有单独来源的值的来源</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>刃部</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>What the flutes sweep</source>
        <translation>刃部旋转扫过的形状</translation>
    </message>
    <message>
        <source>Ball end</source>
        <translation>球头铣刀</translation>
    </message>
    <message>
        <source>Flat end</source>
        <translation>平底铣刀</translation>
    </message>
    <message>
        <source>Bull nose</source>
        <translation>圆鼻铣刀</translation>
    </message>
    <message>
        <source>Tapered</source>
        <translation>锥度铣刀</translation>
    </message>
    <message>
        <source>Tapered ball</source>
        <translation>锥度球头铣刀</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>钻头</translation>
    </message>
    <message>
        <source>Chamfer</source>
        <translation>倒角刀</translation>
    </message>
    <message>
        <source>Lollipop</source>
        <translation>球形T刀</translation>
    </message>
    <message>
        <source>Profile of lines and arcs</source>
        <translation>由直线和圆弧组成的轮廓</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Of the flutes where they are widest</source>
        <translation>刃部最宽处的直径</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>圆角半径</translation>
    </message>
    <message>
        <source>Of the rounded edge, or of the ball at the tip</source>
        <translation>倒圆刃边或刀尖球头的半径</translation>
    </message>
    <message>
        <source>Tip diameter</source>
        <translation>刀尖直径</translation>
    </message>
    <message>
        <source>Of the flat at the tip, before its edge is rounded</source>
        <translation>刀尖平面在其刃边倒圆之前的直径</translation>
    </message>
    <message>
        <source>Between axis and cone: half of a point angle</source>
        <translation>轴线与锥面之间：顶角的一半</translation>
    </message>
    <message>
        <source>Length of the flutes</source>
        <translation>刃部长度</translation>
    </message>
    <message>
        <source>From the tip</source>
        <translation>从刀尖算起</translation>
    </message>
    <message>
        <source>Number of flutes</source>
        <translation>刃数</translation>
    </message>
    <message>
        <source>Cuts at its centre</source>
        <translation>中心可切削</translation>
    </message>
    <message>
        <source>May plunge straight down</source>
        <translation>可以垂直下刀</translation>
    </message>
    <message>
        <source>No</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>刀杆</translation>
    </message>
    <message>
        <source>Shank diameter</source>
        <translation>刀杆直径</translation>
    </message>
    <message>
        <source>Between flutes and holder</source>
        <translation>刃部与刀柄之间</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>伸出长度</translation>
    </message>
    <message>
        <source>From the tip to the face of the holder</source>
        <translation>从刀尖到刀柄端面</translation>
    </message>
    <message>
        <source>As entered below</source>
        <translation>按下面的输入</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>刀柄</translation>
    </message>
    <message>
        <source>Take over the segments of a holder of the library</source>
        <translation>采用刀具库中某个刀柄的各段</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>From the face upwards: diameter below, diameter above, length</source>
        <translation>从端面向上：下端直径、上端直径、长度</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>最大切深</translation>
    </message>
    <message>
        <source>Along the axis; at most the length of the flutes</source>
        <translation>沿轴线；不超过刃部长度</translation>
    </message>
    <message>
        <source>Across the axis</source>
        <translation>垂直于轴线</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高转速</translation>
    </message>
    <message>
        <source>Of the spindle, by the tool&apos;s maker</source>
        <translation>刀具厂家规定的主轴转速</translation>
    </message>
    <message>
        <source>Modulus of elasticity</source>
        <translation>弹性模量</translation>
    </message>
    <message>
        <source>Of what shank and flutes are made of</source>
        <translation>刀杆和刃部所用材料的弹性模量</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Stress at which it breaks when it is bent</source>
        <translation>弯曲时折断的应力</translation>
    </message>
    <message>
        <source>entered by the user</source>
        <translation>由用户输入</translation>
    </message>
    <message>
        <source>Angle per side</source>
        <translation>单侧角度</translation>
    </message>
    <message>
        <source>Teeth that cut in one revolution</source>
        <translation>每转参与切削的齿数</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Greatest width of cut</source>
        <translation>最大切宽</translation>
    </message>
    <message>
        <source>Greatest chip thickness</source>
        <translation>最大切屑厚度</translation>
    </message>
    <message>
        <source>Per tooth</source>
        <translation>每齿</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Of a tool that doesn&apos;t turn, about its axis: from X of the setup to X of its models, counterclockwise seen from above</source>
        <translation>不旋转刀具绕其轴线的方向：从装夹的 X 到模型的 X，从上方看为逆时针</translation>
    </message>
    <message>
        <source>Feeds and speeds</source>
        <translation>进给和转速</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Feeds and speeds of your own. The first preset for the stock&apos;s material is used, without one the first for any material, without one the values that the material states</source>
        <translation>您自己的进给和转速。使用毛坯材料的第一个预设；若没有，则使用任意材料的第一个预设；再没有，则使用材料给出的数值</translation>
    </message>
</context>
<context>
    <name>burin::ToolLibraryBar</name>
    <message>
        <source>All tools</source>
        <translation>所有刀具</translation>
    </message>
    <message>
        <source>Starter library</source>
        <translation>自带刀具库</translation>
    </message>
    <message>
        <source>My tools</source>
        <translation>我的刀具</translation>
    </message>
    <message>
        <source>Tool library</source>
        <translation>刀具库</translation>
    </message>
    <message>
        <source>The tool library whose tools are listed</source>
        <translation>列出其刀具的刀具库</translation>
    </message>
    <message>
        <source>New tool library</source>
        <translation>新建刀具库</translation>
    </message>
    <message>
        <source>Rename this library</source>
        <translation>重命名此刀具库</translation>
    </message>
    <message>
        <source>Delete this library and its tools</source>
        <translation>删除此刀具库及其刀具</translation>
    </message>
    <message>
        <source>Choose a library that you have named yourself.</source>
        <translation>请选择您自己命名的刀具库。</translation>
    </message>
    <message>
        <source>Rename the tool library</source>
        <translation>重命名刀具库</translation>
    </message>
    <message>
        <source>Delete the empty library “%1”?</source>
        <translation>删除空的刀具库“%1”？</translation>
    </message>
    <message>
        <source>Delete the library “%1” and its tool?</source>
        <translation>删除刀具库“%1”及其中的刀具？</translation>
    </message>
    <message numerus="yes">
        <source>Delete the library “%1” and its %n tools?</source>
        <translation>
            <numerusform>删除刀具库“%1”及其中的 %n 把刀具？</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo brings them back. Projects keep the tools that they use.</source>
        <translation>撤销可恢复它们。项目保留其使用的刀具。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>burin::ToolPanel</name>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Choose the tool to mill with</source>
        <translation>选择铣削用的刀具</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>圆角半径</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>刃部</translation>
    </message>
    <message>
        <source>Stick-out</source>
        <translation>伸出长度</translation>
    </message>
    <message>
        <source>Deepest cut</source>
        <translation>最大切深</translation>
    </message>
    <message>
        <source>In this stock</source>
        <translation>在此毛坯中</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>Plunge feed</source>
        <translation>下刀进给</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>%1, %2 long</source>
        <translation>%1，长%2</translation>
    </message>
    <message>
        <source>Feed and speed come from values that are estimates.</source>
        <translation>进给和转速由估计值得出。</translation>
    </message>
    <message>
        <source>The tool can&apos;t be changed while recording.</source>
        <translation>录制期间不能更换刀具。</translation>
    </message>
    <message>
        <source>The boundary for this tool is being computed…</source>
        <translation>正在计算此刀具的边界…</translation>
    </message>
    <message>
        <source>Source of the dimensions</source>
        <translation>尺寸的来源</translation>
    </message>
    <message>
        <source>milled</source>
        <translation>已铣削</translation>
    </message>
    <message>
        <source>1 take was milled with this tool</source>
        <translation>有 1 段录制是用此刀具铣削的</translation>
    </message>
    <message numerus="yes">
        <source>%n takes were milled with this tool</source>
        <translation>
            <numerusform>有 %n 段录制是用此刀具铣削的</numerusform>
        </translation>
    </message>
    <message>
        <source>By the preset “%1” of this tool.</source>
        <translation>按此刀具的预设“%1”。</translation>
    </message>
    <message>
        <source>By the preset “%1” of this tool; the plunge feed by the material.</source>
        <translation>按此刀具的预设“%1”；下刀进给按材料。</translation>
    </message>
    <message>
        <source>This tool doesn&apos;t turn: it cuts what its model sweeps, upright and in a fixed direction. It has no feeds, passes or programs.</source>
        <translation>此刀具不旋转：它按模型扫过的形状切削，保持竖直且方向固定。它没有进给、走刀和程序。</translation>
    </message>
</context>
<context>
    <name>burin::ToolShapeDialog</name>
    <message>
        <source>Tool from models</source>
        <translation>由模型生成刀具</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>刃部</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>刀杆</translation>
    </message>
    <message>
        <source>The same of the shank; without it the new tool has the shank of the other</source>
        <translation>刀杆的同类模型；没有时，新刀具采用原刀具的刀杆</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>What the tool is called</source>
        <translation>刀具的名称</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>T in programs</source>
        <translation>程序中的 T 号</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Make the tool</source>
        <translation>生成刀具</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Choose a model of the flutes first.</source>
        <translation>先选择刃部的模型。</translation>
    </message>
    <message>
        <source>Give the tool a name first.</source>
        <translation>先给刀具命名。</translation>
    </message>
    <message>
        <source>Unit of the files</source>
        <translation>文件的单位</translation>
    </message>
    <message>
        <source>An STL file states no unit</source>
        <translation>STL 文件不注明单位</translation>
    </message>
    <message>
        <source>How much wider than the model the profile of the tool may be; it is never narrower</source>
        <translation>刀具轮廓允许比模型宽多少；绝不会更窄</translation>
    </message>
    <message>
        <source>Add the tool to your own and load it into the spindle; Undo takes it back</source>
        <translation>将刀具加入自己的刀具并装入主轴；撤销可取消</translation>
    </message>
    <message>
        <source>One or more closed bodies: STEP, IGES, BREP, or a mesh</source>
        <translation>一个或多个封闭实体：STEP、IGES、BREP 或网格</translation>
    </message>
    <message>
        <source>Turns with the spindle</source>
        <translation>随主轴旋转</translation>
    </message>
    <message>
        <source>Doesn&apos;t turn: scraper, planing blade</source>
        <translation>不旋转：刮刀、刨刀</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>About the axis: from X of the setup to X of the models, counterclockwise seen from above</source>
        <translation>绕轴线：从装夹的 X 到模型的 X，从上方看为逆时针</translation>
    </message>
    <message>
        <source>A tool that turns cuts what its flutes sweep with the spindle; one that doesn&apos;t turn cuts what its models sweep. Models have their axis along +Z, through the origin, towards the holder; their lowest point becomes the tip. Teeth, limits and holder are those of “%1”.</source>
        <translation>旋转的刀具切除其刃部随主轴扫过的区域；不旋转的刀具切除其模型扫过的区域。模型的轴线沿 +Z，通过原点，指向刀柄；模型的最低点成为刀尖。齿数、限值和刀柄取自“%1”。</translation>
    </message>
    <message>
        <source>A tool that doesn&apos;t turn cuts what its models sweep; their profile only keeps them out of the part</source>
        <translation>不旋转的刀具按模型扫过的形状切削；其轮廓只用来把它们挡在零件之外</translation>
    </message>
</context>
<context>
    <name>burin::TorqueTable</name>
    <message>
        <source>Torque at that speed</source>
        <translation>该转速下的扭矩</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Speed of point %1</source>
        <translation>点 %1 的转速</translation>
    </message>
    <message>
        <source>Torque of point %1</source>
        <translation>点 %1 的扭矩</translation>
    </message>
    <message>
        <source>Delete point %1</source>
        <translation>删除点 %1</translation>
    </message>
    <message>
        <source>There is a point at %1 already. The value stays.</source>
        <translation>%1处已有一个点。数值不变。</translation>
    </message>
    <message>
        <source>There is a point at %1 already; change that one.</source>
        <translation>%1处已有一个点；修改那个点。</translation>
    </message>
    <message>
        <source>Enter a speed and a torque above 0.</source>
        <translation>输入大于 0 的转速和扭矩。</translation>
    </message>
    <message>
        <source>Speed of a new point</source>
        <translation>新点的转速</translation>
    </message>
    <message>
        <source>Add this point to the curve (Enter in the torque field)</source>
        <translation>将此点添加到曲线（在扭矩输入框中按 Enter）</translation>
    </message>
</context>
<context>
    <name>burin::TreePresenter</name>
    <message>
        <source>Setups</source>
        <translation>装夹</translation>
    </message>
    <message>
        <source>Double click: work in this setup.</source>
        <translation>双击：在此装夹中工作。</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Fixtures and keep-out volumes</source>
        <translation>夹具和禁入区</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>夹具</translation>
    </message>
    <message>
        <source>keep-out</source>
        <translation>禁入区</translation>
    </message>
    <message>
        <source>Tick: the tool keeps clear of it.</source>
        <translation>勾选：刀具避开它。</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Double click: load this tool.</source>
        <translation>双击：装入此刀具。</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>刀路</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 个编辑步骤</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n 个编辑步骤</numerusform>
        </translation>
    </message>
    <message>
        <source>Double click: load its tool and edit it.</source>
        <translation>双击：装入其刀具并编辑它。</translation>
    </message>
    <message>
        <source>Right click: order and delete passes.</source>
        <translation>右击：调整走刀顺序和删除走刀。</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>未检查</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>强制放行</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>Double click: show its text and findings.</source>
        <translation>双击：显示其文本和问题。</translation>
    </message>
    <message>
        <source>&amp;Work in it</source>
        <translation>在其中工作(&amp;W)</translation>
    </message>
    <message>
        <source>Switch to this setup.</source>
        <translation>切换到此装夹。</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>重命名(&amp;R)…</translation>
    </message>
    <message>
        <source>Rename the setup.</source>
        <translation>重命名此装夹。</translation>
    </message>
    <message>
        <source>Rename the setup</source>
        <translation>重命名装夹</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the setup, if nothing was recorded in it.</source>
        <translation>如果装夹中没有录制，则删除该装夹。</translation>
    </message>
    <message>
        <source>Delete it from the setup.</source>
        <translation>从装夹中删除。</translation>
    </message>
    <message>
        <source>Mill it &amp;earlier</source>
        <translation>提前铣削(&amp;E)</translation>
    </message>
    <message>
        <source>Mill this pass before the one above.</source>
        <translation>在上面的走刀之前铣削此走刀。</translation>
    </message>
    <message>
        <source>Delete this pass.</source>
        <translation>删除此走刀。</translation>
    </message>
    <message>
        <source>Drag: move it. Right click: switch it off and on, move, duplicate, rename or delete it.</source>
        <translation>拖动：移动录制。右键单击：停用或启用、移动、复制、重命名或删除录制。</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>更改(&amp;C)…</translation>
    </message>
    <message>
        <source>Change its sizes and its position.</source>
        <translation>更改其尺寸和位置。</translation>
    </message>
    <message>
        <source>Rename it.</source>
        <translation>重命名。</translation>
    </message>
    <message>
        <source>Rename the fixture</source>
        <translation>重命名夹具</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>移动(&amp;M)</translation>
    </message>
    <message>
        <source>Move it in the view, with the mouse or the keys.</source>
        <translation>在视图中用鼠标或按键移动它。</translation>
    </message>
</context>
<context>
    <name>burin::ValueForm</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1到%2</translation>
    </message>
    <message>
        <source>%1, or 0: not stated</source>
        <translation>%1，或 0：未注明</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Where this value comes from, e.g. the nameplate or a measurement</source>
        <translation>此数值的来源，例如铭牌或测量</translation>
    </message>
    <message>
        <source>entered by the user</source>
        <translation>由用户输入</translation>
    </message>
</context>
<context>
    <name>burin::ViewBar</name>
    <message>
        <source>Transparency</source>
        <translation>透明度</translation>
    </message>
    <message>
        <source>Transparency of the workpiece.</source>
        <translation>工件的透明度。</translation>
    </message>
    <message>
        <source>Normal of the section plane</source>
        <translation>剖切面的法线</translation>
    </message>
    <message>
        <source>Axis perpendicular to the section plane.</source>
        <translation>与剖切面垂直的轴。</translation>
    </message>
    <message>
        <source>Moves the section plane along its normal.</source>
        <translation>沿法线移动剖切面。</translation>
    </message>
    <message>
        <source>Position of the section plane</source>
        <translation>剖切面的位置</translation>
    </message>
    <message>
        <source>Position of the section plane along its normal.</source>
        <translation>剖切面沿其法线的位置。</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>刀路</translation>
    </message>
    <message>
        <source>Colours of the path</source>
        <translation>刀路的颜色</translation>
    </message>
    <message>
        <source>What the colours of the path show.</source>
        <translation>刀路颜色所表示的内容。</translation>
    </message>
</context>
<context>
    <name>burin::ViewDevice</name>
    <message>
        <source>Connecting the device that moves the view</source>
        <translation>正在连接移动视图的设备</translation>
    </message>
</context>
<context>
    <name>burin::ViewDock</name>
    <message>
        <source>Make it a window of its own, or put it back next to the view</source>
        <translation>变成独立窗口，或放回视图旁边</translation>
    </message>
</context>
<context>
    <name>burin::Viewport</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 in</source>
        <translation>%1 in</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2 or later; this computer offers none. A driver of the graphics card may be missing.</source>
        <translation>3D 视图需要 OpenGL 3.2 或更高版本；这台计算机不提供。可能缺少显卡驱动程序。</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.2 or later; this computer offers %1.%2. A newer driver of the graphics card may help.</source>
        <translation>3D 视图需要 OpenGL 3.2 或更高版本；这台计算机提供的是 %1.%2。更新显卡驱动程序可能有帮助。</translation>
    </message>
    <message>
        <source>Part at %1</source>
        <translation>零件在 %1</translation>
    </message>
    <message>
        <source>%1 deep</source>
        <translation>深 %1</translation>
    </message>
    <message>
        <source>Excess stock, %1</source>
        <translation>残料，%1</translation>
    </message>
</context>
<context>
    <name>burin::WelcomePage</name>
    <message>
        <source>Burin</source>
        <translation>Burin</translation>
    </message>
    <message>
        <source>Mill the part by hand; the machine repeats what your hand did.</source>
        <translation>用手铣削零件，机床重复手的动作。</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Open a part…</source>
        <translation>打开零件…</translation>
    </message>
    <message>
        <source>Try the sample part</source>
        <translation>试用示例零件</translation>
    </message>
    <message>
        <source>Import the part that Burin is shipped with.</source>
        <translation>导入 Burin 附带的零件。</translation>
    </message>
    <message>
        <source>A computer mouse, 110 mm long, ready to be milled.</source>
        <translation>一个 110 mm 长的电脑鼠标，可直接铣削。</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Watch a virtual operator mill the sample part.</source>
        <translation>观看虚拟操作员铣削示例零件。</translation>
    </message>
    <message>
        <source>A virtual operator mills the sample part before your eyes, eight times as fast as a hand.</source>
        <translation>虚拟操作员在眼前铣削示例零件，速度是手的八倍。</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>打开项目…</translation>
    </message>
    <message>
        <source>Open a .burin file.</source>
        <translation>打开 .burin 文件。</translation>
    </message>
    <message>
        <source>Go on with a project that was saved.</source>
        <translation>继续已保存的项目。</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>Burin ended before this work was saved. Nothing of it is lost.</source>
        <translation>Burin 在这项工作保存之前退出了。内容没有丢失。</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近的项目</translation>
    </message>
    <message>
        <source>Projects that you save are listed here.</source>
        <translation>保存的项目会列在这里。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Go on with this work.</source>
        <translation>继续这项工作。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete this work for good.</source>
        <translation>永久删除这项工作。</translation>
    </message>
    <message>
        <source>The sample part, milled.</source>
        <translation>铣削好的示例零件。</translation>
    </message>
    <message>
        <source>Return to the project (Esc)</source>
        <translation>返回项目（Esc）</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>返回%1</translation>
    </message>
    <message>
        <source>Read a part from a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF).</source>
        <translation>从 CAD 文件（STEP、IGES、BREP）或网格（STL、3MF、OBJ、PLY、AMF、OFF）读取零件。</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP, or a mesh (STL, 3MF, OBJ …). Dropping a file on the window does the same.</source>
        <translation>STEP、IGES、BREP 或网格（STL、3MF、OBJ …）。将文件拖到窗口上效果相同。</translation>
    </message>
    <message>
        <source>First job</source>
        <translation>第一个作业</translation>
    </message>
    <message>
        <source>Start a guide through a complete job, step by step.</source>
        <translation>按步骤引导完成一个完整的作业。</translation>
    </message>
    <message>
        <source>From the sample part to a checked program: Burin shows what to press next.</source>
        <translation>从示例零件到检查通过的程序：Burin 指出下一步该按什么。</translation>
    </message>
</context>
<context>
    <name>burin::Workbench</name>
    <message>
        <source>unit of the part</source>
        <translation>零件的单位</translation>
    </message>
    <message>
        <source>updated part</source>
        <translation>更新零件</translation>
    </message>
    <message>
        <source>import of a part</source>
        <translation>导入零件</translation>
    </message>
</context>
<context>
    <name>burin::WorkpieceController</name>
    <message>
        <source>Embedding the part</source>
        <translation>正在嵌入零件</translation>
    </message>
    <message>
        <source>Computing the boundary for %1</source>
        <translation>正在计算%1的边界</translation>
    </message>
    <message>
        <source>Computing the boundary around the tool</source>
        <translation>正在计算刀具周围的边界</translation>
    </message>
    <message>
        <source>Exporting the workpiece</source>
        <translation>正在导出工件</translation>
    </message>
    <message>
        <source>Milling the takes again</source>
        <translation>正在重新铣削录制</translation>
    </message>
    <message>
        <source>Computing the surface of the stock</source>
        <translation>正在计算毛坯表面</translation>
    </message>
</context>
<context>
    <name>burin::WorkpieceKeeper</name>
    <message>
        <source>Storing the workpiece</source>
        <translation>正在存储工件</translation>
    </message>
</context>
<context>
    <name>burin::WorkpiecePicker</name>
    <message>
        <source>Esc: end measuring</source>
        <translation>Esc：结束测量</translation>
    </message>
</context>
<context>
    <name>burin::ZeroLabels</name>
    <message>
        <source>left</source>
        <translation>左侧</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中间</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右侧</translation>
    </message>
    <message>
        <source>front</source>
        <translation>前侧</translation>
    </message>
    <message>
        <source>back</source>
        <translation>后侧</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>底部</translation>
    </message>
    <message>
        <source>top</source>
        <translation>顶部</translation>
    </message>
    <message>
        <source>at stated coordinates</source>
        <translation>在给定的坐标处</translation>
    </message>
    <message>
        <source>on the stock: X %1, Y %2, Z %3</source>
        <translation>毛坯上：X %1，Y %2，Z %3</translation>
    </message>
    <message>
        <source>on the part: X %1, Y %2, Z %3</source>
        <translation>零件上：X %1，Y %2，Z %3</translation>
    </message>
</context>
<context>
    <name>burin::ZeroPanel</name>
    <message>
        <source>Program zero</source>
        <translation>程序零点</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>工件偏置</translation>
    </message>
    <message>
        <source>The control stores program zero in this work offset; the program calls it</source>
        <translation>数控系统将程序零点存储在此工件偏置中；程序会调用它</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>毛坯</translation>
    </message>
    <message>
        <source>part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>Zero on</source>
        <translation>零点位于</translation>
    </message>
    <message>
        <source>Program zero in the frame of the setup</source>
        <translation>装夹坐标系中的程序零点</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>在视图中拾取</translation>
    </message>
    <message>
        <source>Click a vertex, the middle of an edge or a circle of the part, or a corner of the stock: program zero is placed there</source>
        <translation>单击零件的顶点、边的中点或圆，或毛坯的角点：程序零点将放在该处</translation>
    </message>
    <message>
        <source>Click a vertex, an edge or a circle of the part, or a corner of the stock.</source>
        <translation>单击零件的顶点、边或圆，或毛坯的角点。</translation>
    </message>
    <message>
        <source>A point of the bounding box of the stock or the part, or coordinates</source>
        <translation>毛坯或零件包围盒上的点，或坐标</translation>
    </message>
    <message>
        <source>Position on the bounding box along %1</source>
        <translation>在包围盒上沿%1的位置</translation>
    </message>
</context>
<context>
    <name>burin::ZeroPicker</name>
    <message>
        <source>Esc: cancel picking program zero</source>
        <translation>Esc：取消拾取程序零点</translation>
    </message>
</context>
<context>
    <name>burin::ZeroPresenter</name>
    <message>
        <source>The tool does not touch the part. Hold it against a face of the part.</source>
        <translation>刀具没有接触零件。将刀具靠在零件的一个面上。</translation>
    </message>
    <message>
        <source>Touching off needs a vertical tool and a face that is parallel to two axes.</source>
        <translation>对刀需要竖直的刀具和一个与两根轴平行的面。</translation>
    </message>
    <message>
        <source>The tool touches nothing. Hold it against a face of the part, or of the stock after “Stop the tool at the stock”.</source>
        <translation>刀具没有接触任何东西。将刀具靠在零件的一个面上，或在选择“刀具停在毛坯处”后靠在毛坯的一个面上。</translation>
    </message>
    <message>
        <source>The tool doesn&apos;t touch a side of the stock squarely. Hold it against a side that is parallel to two axes, and against nothing else.</source>
        <translation>刀具没有垂直碰触毛坯的侧面。请让刀具只抵住一个平行于两个坐标轴的侧面。</translation>
    </message>
    <message>
        <source>Zero along %1 is set to the touched side, which is known to within %2.</source>
        <translation>%1 方向的零点已设在碰触的侧面，其位置精确到 %2。</translation>
    </message>
</context>
</TS>
