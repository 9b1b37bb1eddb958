using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes a compensation as JSON, in millimeters, or in micrometers if the key says so.</summary>
public static class CompensationReportJson
{
    /// <summary>Writes the document <c>errormatch/surface-compensate/1</c>.</summary>
    public static byte[] Write(CompensationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        var result = report.Result;
        return ReportWriter.Document("errormatch/surface-compensate/1", json =>
        {
            json.Job("freeform", report.Job);
            json.Inputs(report.Inputs);
            WriteCutBy(json, report.CutBy);
            WriteResult(json, result);
            json.Object("toolpath", () => Path(json, report.ToolPath));
            json.Object("program", () =>
            {
                json.Text("file", report.Program.File);
                json.Text("sha256", report.Program.Sha256);
                json.Flag("toolCall", report.CallsTool);
            });
            json.Texts("warnings", report.Warnings);
            json.Texts("notes", result.Notes);
            json.Object("time", () => json.Number("calculatingS", report.CalculatingS));
        });
    }

    /// <summary>Writes the program that cut the measured piece as <c>cutBy</c>, without a file if a nominal one is assumed.</summary>
    public static void WriteCutBy(ReportWriter json, MeasuredPieceProgram cutBy)
    {
        ArgumentNullException.ThrowIfNull(json);
        ArgumentNullException.ThrowIfNull(cutBy);
        json.Object("cutBy", () =>
        {
            json.Text("known", cutBy.File is null ? "assumed" : "named");
            json.Text("file", cutBy.File);
            json.Text("sha256", cutBy.Sha256);
        });
    }

    /// <summary>Writes the members of a compensation into the open object, for a new program or for a displaced one.</summary>
    public static void WriteResult(ReportWriter json, CompensationResult result)
    {
        ArgumentNullException.ThrowIfNull(json);
        ArgumentNullException.ThrowIfNull(result);
        var job = result.Input.Job;
        EvaluationReportJson.Alignment(json, result.Alignment);
        json.Text("stage", MeasuredStage.Name(job.Measuring.After));
        json.Object("before", () => EvaluationReportJson.Statistics(json, result.Before));
        json.Object("structure", () => Structure(json, result.Structure));
        json.Object("compensation", () =>
        {
            json.Text("method", result.Predicted.Method);
            json.Number("gain", job.Compensation.Gain);
            json.Number("limitMm", job.Compensation.LimitMm);
            json.Text("of", job.Fit.OfError ? "error" : "points");
            json.Text("fit", job.Fit.Method.Name);
            json.Number("largestMoveUm", result.LargestMoveMm * 1000);
            Field(json, result.Systematic);
        });
        json.Object("surface", () => Surface(json, result));
        json.Object("predicted", () =>
        {
            json.Object("mirror", () => Prediction(json, result.Mirror));
            json.Object("toolRadius", () => Prediction(json, result.ToolRadius));
        });
        json.List("points", Enumerable.Range(0, result.Samples.Count), i => Point(json, result, i));
        json.Object("map", () => Map(json, ErrorMap.Of(result)));
    }

    private static void Structure(ReportWriter json, SpatialStructure structure)
    {
        json.Text(
            "verdict",
            structure.Verdict switch { SpatialVerdict.Systematic => "systematic", SpatialVerdict.Noise => "noise", _ => "undetermined" });
        if (structure.Verdict != SpatialVerdict.Undetermined)
        {
            json.Exact("moransI", structure.I);
            json.Exact("expected", structure.Expectation);
            json.Exact("z", structure.Z);
            json.Exact("p", structure.P);
        }
    }

    private static void Field(ReportWriter json, ErrorField field)
    {
        if (field is not FittedField fitted)
        {
            json.Text("model", field is ConstantField ? "constant" : "surface-fit");
            return;
        }

        json.Text("model", FieldWords.Of(fitted.Kind));
        json.Numbers("breaksU", fitted.BreaksU);
        json.Numbers("breaksV", fitted.BreaksV);
        json.Number("leaveLineOutUm", Known(fitted.LeaveLineOutMm));
        json.Number("residualStandardDeviationUm", Known(fitted.ResidualStandardDeviationMm));
        json.Number("noiseUm", Known(fitted.NoiseMm));
    }

    // Points on only two lines have no line-out error.
    private static double? Known(double mm) => double.IsFinite(mm) ? mm * 1000 : null;

    private static void Surface(ReportWriter json, CompensationResult result)
    {
        var spline = result.Surface.Spline;
        json.Text("name", result.Surface.Name);
        json.Count("degreeU", spline.KnotsU.Degree);
        json.Count("degreeV", spline.KnotsV.Degree);
        json.Count("polesU", spline.CountU);
        json.Count("polesV", spline.CountV);
        json.Number("approximationUm", result.ApproximationMm * 1000);
    }

    private static void Prediction(ReportWriter json, SurfacePrediction prediction)
    {
        EvaluationReportJson.Statistics(json, prediction.Statistics);
        json.Number("meanUncertaintyUm", prediction.MeanUncertaintyMm * 1000);
        json.Number("pointUncertaintyUm", prediction.PointUncertaintyMm * 1000);
    }

    private static void Path(ReportWriter json, ToolPath path)
    {
        json.Count("passes", path.Passes);
        json.Count("points", path.Points);
        json.Number("lengthMm", path.LengthMm);
        json.Number("chordUm", path.Certificate.ChordMm * 1000);
        json.Number("scallopUm", path.Certificate.ScallopMm * 1000);
        json.Number("gougeUm", path.Certificate.GougeMm * 1000);
        json.Count("raisedPoints", path.Certificate.RaisedPoints);
        json.Number("raisedUm", path.Certificate.RaisedMm * 1000);
    }

    private static void Point(ReportWriter json, CompensationResult result, int index)
    {
        var sample = result.Samples[index];
        var compensated = result.PointOf(sample);
        json.Count("point", sample.Point);
        json.Count("i", sample.I);
        json.Count("j", sample.J);
        json.Number("u", sample.U);
        json.Number("v", sample.V);
        json.Numbers("nominal", [sample.Nominal.X, sample.Nominal.Y, sample.Nominal.Z]);
        json.Numbers("normal", [sample.Normal.X, sample.Normal.Y, sample.Normal.Z]);
        json.Number("errorUm", sample.ErrorMm * 1000);
        json.Number("predictedUm", result.Predicted.Errors[index] * 1000);
        json.Number("mirrorUm", result.Mirror.Errors[index] * 1000);
        json.Number("toolRadiusUm", result.ToolRadius.Errors[index] * 1000);
        json.Numbers("compensated", [compensated.X, compensated.Y, compensated.Z]);
    }

    private static void Map(ReportWriter json, ErrorMap map)
    {
        json.Count("countU", map.Net.CountU);
        json.Count("countV", map.Net.CountV);
        json.Numbers("x", map.Net.Places.Select(p => p.X));
        json.Numbers("y", map.Net.Places.Select(p => p.Y));
        json.Numbers("outside", map.Net.Outside.Select(c => (double)c));
        json.Numbers("errorUm", map.BeforeMm.Select(e => e * 1000));
        json.Numbers("mirrorUm", map.MirrorMm.Select(e => e * 1000));
        json.Numbers("toolRadiusUm", map.ToolRadiusMm.Select(e => e * 1000));
    }
}
