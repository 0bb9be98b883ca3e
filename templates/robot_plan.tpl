{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Experiment plan of a robot: {{TITLE}}</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#joints">Skip to the joints</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · experiment plan of a robot</p>
<h1><bdi>{{TITLE}}</bdi></h1>
<p class="subtitle">What each joint does, and for how long; its name leads to its plan.</p>
{{#FACTS}}<dl class="identity">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
</header>
<main id="content" class="page-body">
{{>VERDICT}}
<section id="order" aria-labelledby="order-title">
<h2 id="order-title">Order</h2>
{{>ORDER}}
</section>
<section id="joints" aria-labelledby="joints-title">
<h2 id="joints-title">Joints</h2>
<div class="cards">
{{#JOINT}}<article class="joint {{OUTCOME}}">
<h3>{{#LINK}}<a href="{{HREF}}"><bdi>{{TEXT}}</bdi></a>{{/LINK}}{{#NO_LINK}}<bdi>{{TEXT}}</bdi>{{/NO_LINK}} <span class="state {{OUTCOME}}">{{STATE}}</span></h3>
{{#REFUSAL_IF}}<p class="refusal"><bdi>{{REFUSAL}}</bdi></p>{{/REFUSAL_IF}}
{{#PLAN}}<p><bdi>{{SENTENCE}}</bdi></p>
<table class="joint-numbers"><caption><bdi>{{CAPTION}}</bdi></caption><thead><tr><th scope="col">What to do</th><th scope="col" class="number">Time</th></tr></thead><tbody>
{{#PART}}<tr class="{{OUTCOME}}"><th scope="row">{{TITLE}}{{#STATE_IF}} <small>{{STATE}}</small>{{/STATE_IF}}{{#MOTION_IF}}<small class="motion"><bdi>{{MOTION}}</bdi></small>{{/MOTION_IF}}</th><td class="number"><bdi>{{TIME}}</bdi></td></tr>
{{/PART}}</tbody></table>{{/PLAN}}
</article>
{{/JOINT}}</div>
</section>
<section id="made" aria-labelledby="made-title">
<h2 id="made-title">How this was made</h2>
<p>The set points of each joint are in its folder, setpoints.csv. Made {{CREATED:x-dates}} with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
</section>
</main>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · all numbers as JSON are embedded in this file, in the element <code>tribolog-robot-plan</code></p></footer>
<script type="application/json" id="tribolog-robot-plan">{{RESULT_JSON:x-json}}</script>
</body>
</html>
