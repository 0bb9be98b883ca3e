{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>Gravity is read in ways that fail differently: from the loop, from the sweep, from both directions of sweep and runs at equal angle, and by the linear regression over everything that moves, which the paper argues against. Where they agree, none of their assumptions is badly wrong. Where they do not, the verdict says so, and what would cause it.</p>
<p>A 95 % interval should hold the true value in 19 of 20 such measurements. The closed form takes it from the scatter of blocks of neighbouring samples. The bootstrap draws the blocks with replacement (neighbours within strokes, whole cycles, tenths of a plateau, runs) and carries each draw through the chain, from angle to gravity, masses, curves and parameters, so that what has a common cause moves together. Few blocks are paid for by Student's t.</p>
</div>
