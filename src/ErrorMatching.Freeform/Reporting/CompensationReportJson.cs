using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A compensation as JSON: millimetres, and micrometres where the key says so.</summary>
public static class CompensationReportJson
{
    /// <summary>The document <c>errormatch/surface-compensate/1</c>.</summary>
    public static byte[] Write(CompensationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        var (result, job) = (report.Result, report.Result.Input.Job);
        return ReportWriter.Document("errormatch/surface-compensate/1", json =>
        {
            json.Job("freeform", report.Job);
            json.Inputs(report.Inputs);
            EvaluationReportJson.Alignment(json, result.Alignment);
            json.Object("before", () => EvaluationReportJson.Statistics(json, result.Before));
            json.Object("structure", () => Structure(json, result.Structure));
            json.Object("compensation", () =>
            {
                json.Text("method", result.Predicted.Method);
                json.Number("gain", job.Compensation.Gain);
                json.Number("limitMm", job.Compensation.LimitMm);
                json.Text("of", job.Fit.OfError ? "error" : "points");
                json.Text("fit", FitMethods.NameOf(job.Fit.Method));
                json.Number("largestMoveUm", result.LargestMoveMm * 1000);
                Field(json, result.Systematic);
            });
            json.Object("surface", () => Surface(json, result));
            json.Object("predicted", () =>
            {
                json.Object("mirror", () => Prediction(json, result.Mirror));
                json.Object("toolRadius", () => Prediction(json, result.ToolRadius));
            });
            json.Object("toolpath", () => Path(json, report.ToolPath));
            json.Object("program", () =>
            {
                json.Text("file", report.Program.File);
                json.Text("sha256", report.Program.Sha256);
            });
            json.List("points", result.Samples.Zip(result.Predicted.Errors), p => Point(json, p.First, p.Second, result.PointOf(p.First)));
            json.Texts("warnings", result.Warnings);
            json.Texts("notes", result.Notes);
            json.Object("time", () => json.Number("calculatingS", report.CalculatingS));
        });
    }

    private static void Structure(ReportWriter json, SpatialStructure structure)
    {
        json.Text("verdict", structure.Verdict switch { SpatialVerdict.Systematic => "systematic", SpatialVerdict.Noise => "noise", _ => "undetermined" });
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
        json.Number("leaveLineOutUm", fitted.LeaveLineOutMm * 1000);
        json.Number("residualStandardDeviationUm", fitted.ResidualStandardDeviationMm * 1000);
        json.Number("noiseUm", fitted.NoiseMm * 1000);
    }

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

    private static void Point(ReportWriter json, ErrorSample sample, double predictedMm, Point3 compensated)
    {
        json.Count("point", sample.Point);
        json.Count("i", sample.I);
        json.Count("j", sample.J);
        json.Number("u", sample.U);
        json.Number("v", sample.V);
        json.Numbers("nominal", [sample.Nominal.X, sample.Nominal.Y, sample.Nominal.Z]);
        json.Numbers("normal", [sample.Normal.X, sample.Normal.Y, sample.Normal.Z]);
        json.Number("errorUm", sample.ErrorMm * 1000);
        json.Number("predictedUm", predictedMm * 1000);
        json.Numbers("compensated", [compensated.X, compensated.Y, compensated.Z]);
    }
}
