{{%AUTOESCAPE context="HTML"}}
{{#IN_PRINT_IF}}<p>{{IN_PRINT}}</p>
{{/IN_PRINT_IF}}{{>CHECKS}}
{{#TOLD}}<ul class="told" aria-label="Told, not checked">
{{#ENTRY}}<li>{{TEXT:x-symbols}}</li>
{{/ENTRY}}</ul>
{{/TOLD}}
