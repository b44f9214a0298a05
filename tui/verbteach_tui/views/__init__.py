"""What is shown, as plain values and drawn rows; knows no Textual and no prompt-toolkit."""
