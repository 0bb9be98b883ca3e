{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>Gravity is estimated by methods that fail in different ways: from the loop, from the sweep, from both directions of sweep and runs at equal angle, and by linear regression over all moving samples, which the paper argues against. Where they agree, none of their assumptions is badly wrong. Where they do not, the verdict says so, and what would cause it.</p>
<p>A 95 % interval should contain the true value in 19 of 20 such measurements. The closed form takes it from the scatter of blocks of neighbouring samples. The block bootstrap draws the blocks with replacement (neighbours within strokes, whole cycles, tenths of a plateau, runs) and carries each draw through the chain, from angle to gravity, masses, curves and parameters, so that errors with a common cause move together. Student's t allows for a small number of blocks.</p>
</div>
