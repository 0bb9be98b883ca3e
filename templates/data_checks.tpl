{{%AUTOESCAPE context="HTML"}}
<section id="data-checks" aria-labelledby="data-checks-title">
<h2 id="data-checks-title">Checks on the data <a class="self" href="#data-checks" aria-label="Link to this section">#</a></h2>
<p>Before any fit, the recordings are compared with each other and with what a joint can do. A check that fails lowers the verdict of the quantities it affects; a warning is reported and lowers nothing. The number is that of the worst recording.</p>
<div class="table-box long" id="table-data-checks" tabindex="0" role="region" aria-labelledby="table-data-checks-caption">
<table class="judged">
<caption id="table-data-checks-caption"><span>Each check with its number and its limit</span></caption>
<thead><tr><th scope="col">Check</th><th scope="col">Result</th><th scope="col" class="number">Measured</th><th scope="col" class="number">Limit</th><th scope="col">What was found</th></tr></thead>
<tbody>
{{#CHECK}}<tr id="{{CHECK_ID}}"><th scope="row">{{TITLE}}{{#MEASURE_IF}}<small>{{MEASURE}}</small>{{/MEASURE_IF}}</th><td><span class="state {{OUTCOME}}"><span aria-hidden="true">{{ICON}}</span> {{STATE}}</span></td><td class="number" data-name="Measured">{{MEASURED}}</td><td class="number" data-name="Limit">{{LIMIT}}</td><td class="words"><p><bdi>{{FOUND}}</bdi></p>{{#CONSEQUENCE_IF}}<p><bdi>{{CONSEQUENCE}}</bdi></p>{{/CONSEQUENCE_IF}}{{#EXPERIMENT_IF}}<p class="next"><b>Next:</b> <bdi>{{EXPERIMENT}}</bdi></p>{{/EXPERIMENT_IF}}{{#RECORDING_IF}}<small><bdi>{{RECORDING}}</bdi></small>{{/RECORDING_IF}}</td></tr>
{{/CHECK}}</tbody>
</table>
</div>
{{#HAS_RULES}}<div class="table-box long" id="table-rules" tabindex="0" role="region" aria-labelledby="table-rules-caption">
<table class="judged">
<caption id="table-rules-caption"><span>Rules of the verdict: what the fits show, and the value above which a rule lowers the verdict of the quantities named</span></caption>
<thead><tr><th scope="col">Rule</th><th scope="col">Result</th><th scope="col" class="number">Measured</th><th scope="col" class="number">Limit</th><th scope="col">What was found, and which quantities it lowers</th></tr></thead>
<tbody>
{{#RULE}}<tr id="{{CHECK_ID}}"><th scope="row">{{TITLE}}</th><td><span class="state {{OUTCOME}}"><span aria-hidden="true">{{ICON}}</span> {{STATE}}</span></td><td class="number" data-name="Measured">{{MEASURED}}</td><td class="number" data-name="Limit">{{LIMIT}}</td><td class="words"><p><bdi>{{FOUND}}</bdi></p>{{#CONSEQUENCE_IF}}<p><bdi>{{CONSEQUENCE}}</bdi></p>{{/CONSEQUENCE_IF}}</td></tr>
{{/RULE}}</tbody>
</table>
</div>
{{/HAS_RULES}}</section>
