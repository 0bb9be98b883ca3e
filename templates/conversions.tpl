{{%AUTOESCAPE context="HTML"}}
<section id="conversions" aria-labelledby="conversions-title">
<h2 id="conversions-title">From the log to the motor shaft <a class="self" href="#conversions" aria-label="Link to this section">#</a></h2>
<p>Each signal is the number in the log times one factor, the product of the steps shown; every row gets the same factor. Angles and speeds are referred to the joint, torques to the motor.</p>
{{>TABLE}}
</section>
