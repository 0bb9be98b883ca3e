{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Where the method can be trusted</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the results</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · Monte-Carlo study</p>
<h1>Where the method can be trusted</h1>
<p class="subtitle">Bias, scatter and coverage of every estimator, from runs of known truth: one factor at a time around the base case.</p>
{{#FACTS}}<dl class="identity">
{{#FACT}}<div><dt>{{NAME}}</dt><dd><bdi>{{TEXT}}</bdi></dd></div>
{{/FACT}}</dl>{{/FACTS}}
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Outcome</a></li>
<li><a href="#trust">Limits of trust</a></li>
{{#CONTENTS_ENTRY}}<li class="stage"><a href="#{{SECTION_ID}}">{{TITLE}}</a></li>
{{/CONTENTS_ENTRY}}
<li><a href="#how">How it was done</a></li>
</ol>
</nav>
<main id="content">
{{>VERDICT}}
<section id="trust" aria-labelledby="trust-title">
<h2 id="trust-title">Limits of trust <a class="self" href="#trust" aria-label="Link to this section">#</a></h2>
<p>For each factor, the unbroken range of levels around the base case at which the criterion is met. “No”: the estimator fails it already in the base case, as a biased one does. A dash: the recordings of that factor do not show it.</p>
{{>TRUST}}
</section>
{{#FACTOR}}<section id="{{SECTION_ID}}" class="stage" aria-labelledby="{{SECTION_ID}}-title">
<h2 id="{{SECTION_ID}}-title">{{TITLE}} <a class="self" href="#{{SECTION_ID}}" aria-label="Link to this section">#</a></h2>
<p>{{NOTE_TEXT}}</p>
{{>FIGURE}}
{{#TABLES}}<details class="fold"><summary>Bias, scatter and coverage as tables</summary>
{{>TABLE}}
</details>{{/TABLES}}
</section>
{{/FACTOR}}
<details class="folded"><summary>How it was done</summary>
<section id="how" aria-labelledby="how-title">
<h2 id="how-title">How it was done <a class="self" href="#how" aria-label="Link to this section">#</a></h2>
<p>Each run adds its own noise to the ideal recordings of the scenario, and ripple with its own phases; the recordings go through the whole identification, and every number is compared with the scenario. Run by run the random numbers are the same at all levels, so that levels differ by their factor and not by chance. The number of threads makes no difference.</p>
<p>Gravity torque, angle of the peak, break-away torque, bristle stiffness and eq. (6) have their true values from the scenario. The straight line through the curve and the sweep's friction have none of their own: theirs are what the same motions give without any noise.</p>
<p>An estimator is called biased where its bias exceeds three of its own standard errors and is also large enough to matter: 0.1 % of the gravity torque, 0.02° of the angle, 1 % of a friction parameter. Points A to F are read as in the paper, in the first strokes from rest; A and B also in the steady loop, as the mean over its cycles.</p>
<details><summary>The scenario, <code><bdi>{{SCENARIO_FILE}}</bdi></code></summary>
<pre class="command"><bdi>{{SCENARIO_TEXT}}</bdi></pre>
</details>
<p>The same scenario, seed and program give the same numbers again. Made {{CREATED:x-dates}} with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
</section>
</details>
<p class="on-paper">Tables of each factor, and how the study was done, are folded in the file, and are not printed unless they are unfolded first.</p>
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · all numbers as JSON are embedded in this file, in the element <code>tribolog-study</code></p></footer>
<script type="application/json" id="tribolog-study">{{RESULT_JSON:x-json}}</script>
</body>
</html>
