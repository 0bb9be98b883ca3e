{{%AUTOESCAPE context="HTML"}}
<section id="next-experiment" class="next" aria-labelledby="next-experiment-title">
<h3 id="next-experiment-title">Next experiment</h3>
<p><bdi>{{TEXT}}</bdi> <small>{{QUANTITIES}}</small>{{#MORE}} <a href="#next-steps">{{COUNT}}</a>{{/MORE}}</p>
{{#PARTS_IF}}<p>What is not usable yet takes {{PARTS}}, within the angles, speeds and torques of these recordings. <code>tribolog plan REPORT.html -o next</code> writes the set points and what to expect.</p>
{{/PARTS_IF}}</section>
