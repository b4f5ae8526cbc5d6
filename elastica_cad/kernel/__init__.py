"""OpenCASCADE: records become shapes and STEP files, edges and solids become curves."""
