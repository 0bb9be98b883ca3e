{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Two calibrations: {{TITLE}}</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the result</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · two calibrations side by side</p>
<h1><bdi>{{TITLE}}</bdi></h1>
<p class="subtitle">What changed, by how much, and whether it is more than chance.</p>
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Outcome</a></li>
<li><a href="#changes">Changes</a></li>
<li><a href="#curves">Curves</a></li>
<li><a href="#conditions">Conditions</a></li>
<li><a href="#made">How this was made</a></li>
</ol>
</nav>
<main id="content">
{{>VERDICT}}
<section id="changes" aria-labelledby="changes-title">
<h2 id="changes-title">Changes <a class="self" href="#changes" aria-label="Link to this section">#</a></h2>
{{#DIFFERENCES}}<div class="differences" role="group" aria-labelledby="differences-title">
<p id="differences-title">Change from the first to the second, in per cent of the first, with its 95 % interval; an arrow: it goes on beyond the axis</p>
<p class="scale" aria-hidden="true"><span class="ends"><span>{{FROM}}</span><span>0</span><span>{{TO}}</span></span></p>
{{#DIFFERENCE}}<div class="difference {{KIND}}"><span class="name"><bdi>{{QUANTITY}}</bdi></span><span class="strip">{{#DRAWN}}<svg viewBox="0 0 400 24" preserveAspectRatio="none" aria-hidden="true"><path class="zero" d="{{ZERO}}"/><path class="interval" d="{{INTERVAL}}"/><path class="dot" d="{{DOT}}"/></svg>{{/DRAWN}}</span><span class="size"><bdi>{{CHANGE}}</bdi>{{#PERCENT_IF}} <small><bdi>{{PERCENT}}</bdi></small>{{/PERCENT_IF}}</span><span class="word">{{WORD}}</span></div>
{{/DIFFERENCE}}</div>{{/DIFFERENCES}}
{{>CHANGES}}
</section>
<section id="curves" aria-labelledby="curves-title">
<h2 id="curves-title">Curves <a class="self" href="#curves" aria-label="Link to this section">#</a></h2>
{{#REVIEW}}<div id="review" class="review" role="region" aria-labelledby="review-title" hidden>
<h3 id="review-title">Both calibrations laid over each other</h3>
</div>{{/REVIEW}}
{{>FIGURE}}
{{#CURVES_MISSING_IF}}<p><bdi>{{CURVES_MISSING}}</bdi></p>{{/CURVES_MISSING_IF}}
</section>
<section id="conditions" aria-labelledby="conditions-title">
<h2 id="conditions-title">Conditions <a class="self" href="#conditions" aria-label="Link to this section">#</a></h2>
{{>CONDITIONS}}
<p>The intervals cover what the recordings of one calibration show. How much the joint varies from day to day is in its trend over many calibrations: <code>tribolog archive trend</code>.</p>
</section>
<section id="made" aria-labelledby="made-title">
<h2 id="made-title">How this was made <a class="self" href="#made" aria-label="Link to this section">#</a></h2>
<p>From the archive, {{CREATED:x-dates}}, with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
</section>
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · all numbers as JSON are embedded in this file, in the element <code>tribolog-diff</code></p></footer>
<script type="application/json" id="tribolog-diff">{{RESULT_JSON:x-json}}</script>
{{#REVIEW_DATA}}<script type="application/json" id="tribolog-loops">{{LOOPS_JSON:x-json}}</script>
<script>{{SCRIPT:x-script}}</script>{{/REVIEW_DATA}}
</body>
</html>
