# Names of followers, limits, families and laws where people read them; without a row they show as typed.
name-none = none
