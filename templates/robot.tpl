{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Robot: {{TITLE}}</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#joints">Skip to the joints</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · all joints of a robot</p>
<h1><bdi>{{TITLE}}</bdi></h1>
<p class="subtitle">All joints' numbers side by side, then each joint's verdict and pictures; a name leads to the joint's report.</p>
{{#FACTS}}<dl class="identity">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT:x-dates}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
</header>
<main id="content" class="page-body">
{{>VERDICT}}
{{#MATRIX}}<section id="numbers" aria-labelledby="numbers-title">
<h2 id="numbers-title">Quantities by joint</h2>
<p class="matrix-note" id="matrix-note">At the motor, with expanded uncertainty, 95 %. A number without a remark is usable.</p>
<div class="wide" role="region" tabindex="0" aria-labelledby="numbers-title">
<table class="matrix" aria-describedby="matrix-note"><caption><span class="spoken">Quantities by joint</span></caption>
<thead><tr><th scope="col">Quantity</th>{{#HEAD}}<th scope="col">{{#LINK}}<a href="{{HREF}}"><bdi>{{TEXT}}</bdi></a>{{/LINK}}{{#NO_LINK}}<bdi>{{TEXT}}</bdi>{{/NO_LINK}} <span class="state {{OUTCOME}}">{{VERDICT}}</span></th>{{/HEAD}}</tr></thead>
<tbody>
{{#ROW}}<tr><th scope="row">{{WORDS}}{{#UNIT_IF}} <span class="unit">[{{UNIT}}]</span>{{/UNIT_IF}}</th>{{#CELL}}<td class="number {{OUTCOME}}"><bdi>{{TEXT}}</bdi>{{#VERDICT_IF}}<small>{{VERDICT}}</small>{{/VERDICT_IF}}{{#CHANGE_IF}}<small class="{{CHANGE_KIND}}">since last: <bdi>{{CHANGE}}</bdi>{{#CHANGE_WORD_IF}}, {{CHANGE_WORD}}{{/CHANGE_WORD_IF}}</small>{{/CHANGE_IF}}</td>{{/CELL}}</tr>
{{/ROW}}</tbody></table>
</div>
</section>
{{/MATRIX}}<section id="joints" aria-labelledby="joints-title">
<h2 id="joints-title">Joints</h2>
<div class="cards">
{{#JOINT}}<article class="joint {{OUTCOME}}">
<h3>{{#LINK}}<a href="{{HREF}}"><bdi>{{TEXT}}</bdi></a>{{/LINK}}{{#NO_LINK}}<bdi>{{TEXT}}</bdi>{{/NO_LINK}} <span class="state {{OUTCOME}}">{{VERDICT}}</span></h3>
{{#REFUSAL_IF}}<p class="refusal"><bdi>{{REFUSAL}}</bdi></p>{{/REFUSAL_IF}}
{{#NUMBERS}}{{#SENTENCE_IF}}<p><bdi>{{SENTENCE}}</bdi></p>
{{/SENTENCE_IF}}<div class="thumbnails">
{{#THUMBNAIL}}<figure><svg viewBox="0 0 240 130" aria-hidden="true"><path class="zero" d="{{ZERO}}"/><path class="{{KIND}}" d="{{MEASURED}}"/>{{#FITTED_IF}}<path class="fitted" d="{{FITTED}}"/>{{/FITTED_IF}}</svg><figcaption>{{NAME}}: {{SIZE}}</figcaption></figure>
{{/THUMBNAIL}}</div>{{/NUMBERS}}
</article>
{{/JOINT}}</div>
</section>
<section id="made" aria-labelledby="made-title">
<h2 id="made-title">How this was made</h2>
<p>In the pictures, dark: measured; light: the fitted model; dashed: no torque. Made {{CREATED:x-dates}} with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
</section>
</main>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · its numbers as JSON are embedded in this file, in the element <code>tribolog-robot</code></p></footer>
<script type="application/json" id="tribolog-robot">{{RESULT_JSON:x-json}}</script>
</body>
</html>
