"""Force fields: what pushes bodies without touching them. Only worlds that have any compile or run this."""
