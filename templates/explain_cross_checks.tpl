{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>Gravity is estimated in ways that fail differently: by the model of sweeps and runs, which takes off what it finds of an offset, of hoses and of friction by direction, from the loop's mid-line and pairs of points, and by LuGre fitted to all loops. Where they agree, none of their assumptions is badly wrong. Where they do not, the verdict says so, and what would cause it.</p>
</div>
