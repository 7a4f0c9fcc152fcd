"""One run: what is looked at before, the steps, the recording, the estimate of its error."""
