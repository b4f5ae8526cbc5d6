from elastica_cad.design.check_report import report_check as report_check
from elastica_cad.design.design_file import Design as Design, read_design as read_design
from elastica_cad.design.kit_spec import Cutting as Cutting
from elastica_cad.design.model_report import MODEL_SCHEMA as MODEL_SCHEMA, report_model as report_model
from elastica_cad.design.reports import (
    REPORT_SCHEMA as REPORT_SCHEMA,
    report_strip as report_strip,
)
