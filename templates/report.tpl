{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>{{DOCUMENT_TITLE}} – identification report</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the results</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · {{SUBTITLE}}</p>
<h1><bdi>{{DOCUMENT_TITLE}}</bdi></h1>
{{#FACTS}}<dl class="identity">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
{{#NOTE}}<div class="free">{{#NOTE_LINE}}<p><bdi>{{TEXT}}</bdi></p>{{/NOTE_LINE}}</div>{{/NOTE}}
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Verdict</a></li>
{{#HAS_QUANTITIES}}<li><a href="#quantities">Quantities</a></li>{{/HAS_QUANTITIES}}
<li><a href="#key-numbers">Key numbers</a></li>
{{#HAS_MISSING}}<li><a href="#missing">What is missing, and why</a></li>{{/HAS_MISSING}}
{{#HAS_DATA_CHECKS}}<li><a href="#data-checks">Checks on the data</a></li>{{/HAS_DATA_CHECKS}}
{{#HAS_CONVERSIONS}}<li><a href="#conversions">From the log to the motor shaft</a></li>{{/HAS_CONVERSIONS}}
{{#CONTENTS_ENTRY}}<li class="stage"><a href="#{{SECTION_ID}}">{{NUMBER}}. {{TITLE}}</a> <span class="state {{OUTCOME}}">{{STATUS}}</span></li>
{{/CONTENTS_ENTRY}}
<li><a href="#intervals">About the method and its intervals</a></li>
<li><a href="#provenance">Provenance</a></li>
</ol>
</nav>
<main id="content">
{{>VERDICT}}
{{>QUANTITIES}}
<section id="key-numbers" aria-labelledby="key-numbers-title">
<h2 id="key-numbers-title">Key numbers <a class="self" href="#key-numbers" aria-label="Link to this section">#</a></h2>
{{>KEY_NUMBERS}}
{{>BUDGET}}
</section>
{{>MISSING}}
{{>DATA_CHECKS}}
{{>CONVERSIONS}}
{{>STAGE}}
<details class="folded"><summary>About the method and its intervals</summary>
<section id="intervals" aria-labelledby="intervals-title">
<h2 id="intervals-title">About the method and its intervals <a class="self" href="#intervals" aria-label="Link to this section">#</a></h2>
<p>The method is that of “Viscous friction measurement technique in robot joint with the use of surrogate mass”. Where an equation is misprinted there, this program follows the corrected form; <code>tribolog paper</code> shows each misprint with its evidence.</p>
<p>Every interval is meant to contain the true value in 95 of 100 repetitions of the same measurement. “3.8832 ± 0.0043” stands for the interval from 3.8789 to 3.8875; where an interval is asymmetric only its two ends are given. The half width is printed to two significant digits, and the estimate is rounded to the same place.</p>
<p>Intervals come from the scatter left by the fit or the mean, widened according to how many samples are really independent. They do not cover what no single dataset shows: an error of the torque constant or the gear ratio, temperature, wear, or a torque ripple that repeats with motor position. A wrong torque constant scales all torques and masses alike and leaves all angles unchanged.</p>
</section>
</details>
<details class="folded"><summary>Provenance</summary>
{{>PROVENANCE}}
</details>
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED}} · the full result as JSON is embedded in this file, in the element <code>tribolog-result</code></p></footer>
<script type="application/json" id="tribolog-result">{{RESULT_JSON:x-json}}</script>
{{#REVIEW_DATA}}<script type="application/json" id="tribolog-loops">{{LOOPS_JSON:x-json}}</script>
<script>{{SCRIPT:x-script}}</script>{{/REVIEW_DATA}}
</body>
</html>
