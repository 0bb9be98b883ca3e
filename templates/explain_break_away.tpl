{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>The joint stands, and the torque rises slowly until it slides. Before that the contact yields a little, which is pre-sliding; at break-away it yields without limit. The moment is told without a scale of its own: where the joint moves thirty times faster than on average since the ramp began. Of the driving torque there, gravity is taken off where it is known; what is left is the break-away torque.</p>
<p>A ramp that ends before break-away gives a bound and no value: friction is larger than what it reached. Such censored ramps are listed and take no part in the means, which they would pull down.</p>
</div>
