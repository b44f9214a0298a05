"""The lab: training and comparing question policies in a process of its own. No Textual here."""
