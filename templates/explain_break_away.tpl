{{%AUTOESCAPE context="HTML"}}
<div class="explain">
<p>The joint is at rest, and the torque rises slowly until it slides. Before that the contact yields a little, which is pre-sliding; at break-away it yields without limit. Break-away is detected without an absolute threshold: where the joint moves thirty times faster than on average since the ramp began. Gravity, where known, is subtracted from the driving torque at that moment; what is left is the break-away torque.</p>
<p>A ramp that ends before break-away gives a bound, not a value: friction is larger than the torque it reached. Such censored ramps are listed but left out of the means, which they would pull down.</p>
</div>
