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
<p class="kicker">Identification report <bdi>{{REPORT_NUMBER}}</bdi></p>
<h1><bdi>{{DOCUMENT_TITLE}}</bdi></h1>
{{#NOTE}}<div class="free">{{#NOTE_LINE}}<p><bdi>{{TEXT}}</bdi></p>{{/NOTE_LINE}}</div>{{/NOTE}}
</header>
<main id="content">
{{>LOG_PICTURE}}
<div class="page-one">
<div class="answer">
{{>VERDICT}}
{{>QUANTITIES}}
{{>NEXT_EXPERIMENT}}
</div>
<div class="key-pictures">
{{>KEY_PICTURE}}
{{>FRICTION_SPEEDS}}
</div>
<div class="page-terms">
{{>CERTIFICATE}}
</div>
</div>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Page one</a></li>
{{#HAS_FINDINGS}}<li><a href="#findings">Findings, and what to record next</a></li>{{/HAS_FINDINGS}}
{{#HAS_BUDGET}}<li><a href="#budget">Uncertainty budget</a></li>{{/HAS_BUDGET}}
{{#CONTENTS_ENTRY}}<li class="stage"><a href="#{{SECTION_ID}}">{{NUMBER}}. {{TITLE}}</a> <span class="state {{OUTCOME}}">{{STATUS}}</span></li>
{{/CONTENTS_ENTRY}}
{{#HAS_DATA_CHECKS}}<li><a href="#data-checks">Checks on the data</a></li>{{/HAS_DATA_CHECKS}}
<li><a href="#key-numbers">Numbers on both sides of the gear</a></li>
{{#HAS_CONVERSIONS}}<li><a href="#conversions">From the log to the motor shaft</a></li>{{/HAS_CONVERSIONS}}
<li><a href="#intervals">About the method and its intervals</a></li>
<li><a href="#provenance">Provenance</a></li>
</ol>
</nav>
<div class="body">
{{>FURTHER_FINDINGS}}
{{#HAS_BUDGET}}<section id="budget" aria-labelledby="budget-title">
<h2 id="budget-title">Uncertainty budget <a class="self" href="#budget" aria-label="Link to this section">#</a></h2>
{{>BUDGET}}
</section>{{/HAS_BUDGET}}
{{>STAGE}}
{{#HAS_DATA_CHECKS}}<details class="folded"><summary>Checks on the data, and rules of the verdict <small>{{CHECKS_PASSED}}</small></summary>
{{>DATA_CHECKS}}
</details>{{/HAS_DATA_CHECKS}}
<details class="folded"><summary>Numbers on both sides of the gear</summary>
<section id="key-numbers" aria-labelledby="key-numbers-title">
<h2 id="key-numbers-title">Numbers on both sides of the gear <a class="self" href="#key-numbers" aria-label="Link to this section">#</a></h2>
{{>KEY_NUMBERS}}
</section>
</details>
{{#HAS_CONVERSIONS}}<details class="folded"><summary>From the log to the motor shaft</summary>
{{>CONVERSIONS}}
</details>{{/HAS_CONVERSIONS}}
<details class="folded"><summary>About the method and its intervals</summary>
<section id="intervals" aria-labelledby="intervals-title">
<h2 id="intervals-title">About the method and its intervals <a class="self" href="#intervals" aria-label="Link to this section">#</a></h2>
<p>The method is that of “Viscous friction measurement technique in robot joint with the use of surrogate mass”. Where an equation is misprinted there, this program follows the corrected form; <code>tribolog paper</code> shows each misprint with its evidence.</p>
<p>Every interval is meant to contain the true value in 95 of 100 repetitions of the same measurement. “3.8832 ± 0.0043” stands for the interval from 3.8789 to 3.8875; where an interval is asymmetric only its two ends are given. The half width is printed to two significant digits, and the estimate is rounded to the same place.</p>
<p>Intervals contain the scatter that the recordings show, and what these do not exclude: an offset, hoses, a lag, friction that changes with load, angle, time or from day to day, each of a typical size unless the manifest states it. They do not contain wear, nor temperatures and loads other than those recorded. A wrong torque constant scales all torques and masses alike and leaves all angles unchanged; how well it is known, the manifest states under <code>[uncertainty]</code>.</p>
</section>
</details>
<details class="folded"><summary>Provenance</summary>
{{>PROVENANCE}}
</details>
<p class="on-paper">Method, tables, checks and further figures are folded in the file <bdi>{{REPORT_NUMBER}}</bdi> and are not printed unless they are unfolded first. End of the report.</p>
</div>
</div>
</main>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · the full result as JSON is embedded in this file, in the element <code>tribolog-result</code></p></footer>
<script type="application/json" id="tribolog-result">{{RESULT_JSON:x-json}}</script>
{{#REVIEW_DATA}}<script type="application/json" id="tribolog-loops">{{LOOPS_JSON:x-json}}</script>
<script>{{SCRIPT:x-script}}</script>{{/REVIEW_DATA}}
</body>
</html>
