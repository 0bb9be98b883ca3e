{{%AUTOESCAPE context="HTML"}}
<!DOCTYPE html>
<html lang="{{LANGUAGE}}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{{CSP}}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="{{TOOL}}">
<title>Trend: {{TITLE}}</title>
<style>{{CSS:x-css}}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the result</a>
<header class="page-head">
<p class="kicker">{{TOOL}} · calibrations over time</p>
<h1><bdi>{{TITLE}}</bdi></h1>
<p class="subtitle">What has changed, since when, and whether it is more than chance.</p>
</header>
<div class="layout">
<nav class="contents" aria-label="Contents">
<h2 id="contents">Contents</h2>
<ol>
<li><a href="#verdict">Outcome</a></li>
{{#JOINT_LINK}}<li><a href="#{{LINK_ID}}"><bdi>{{LINK_TITLE}}</bdi></a></li>
{{/JOINT_LINK}}<li><a href="#made">How this was made</a></li>
</ol>
</nav>
<main id="content">
{{>VERDICT}}
{{#JOINT}}<section id="{{JOINT_ID}}" aria-labelledby="{{JOINT_ID}}-title">
<h2 id="{{JOINT_ID}}-title"><bdi>{{JOINT_TITLE}}</bdi> <a class="self" href="#{{JOINT_ID}}" aria-label="Link to this section">#</a></h2>
<p><bdi>{{JOINT_WORDS:x-dates}}</bdi></p>
{{>TREND}}
{{#NOTES}}<ul>
{{#NOTE}}<li><bdi>{{TEXT:x-dates}}</bdi></li>
{{/NOTE}}</ul>{{/NOTES}}
{{>FIGURE}}
<details><summary>How a change is distinguished from scatter</summary>
<p>{{CHART_WORDS}}</p>
</details>
</section>{{/JOINT}}
<section id="made" aria-labelledby="made-title">
<h2 id="made-title">How this was made <a class="self" href="#made" aria-label="Link to this section">#</a></h2>
<p>From the archive, {{CREATED:x-dates}}, with:</p>
<pre class="command"><bdi>{{COMMAND_LINE}}</bdi></pre>
</section>
</main>
</div>
<footer class="page-foot"><p>{{TOOL}} · made {{CREATED:x-dates}} · all numbers as JSON are embedded in this file, in the element <code>tribolog-trend</code></p></footer>
<script type="application/json" id="tribolog-trend">{{RESULT_JSON:x-json}}</script>
</body>
</html>
