"""Which question when: features, learners and question policies."""
