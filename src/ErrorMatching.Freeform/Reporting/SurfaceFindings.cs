using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>What a report states about the compensation of a surface, for a generated and for a displaced program alike: the members
/// that both documents share. Lengths in millimeters; in the document, in micrometers if the key says so.</summary>
public sealed record SurfaceFindings
{
    /// <summary>The verdict by the job's profile tolerance; null if the job states none, and in older reports.</summary>
    public required SurfaceVerdict? Verdict { get; init; }

    /// <summary>The program that cut the measured piece; not stated in older reports.</summary>
    public required MeasuredPieceProgram CutBy { get; init; }

    /// <summary>The alignment of the points to the surface; null if they were not moved.</summary>
    public required SurfaceAlignment? Alignment { get; init; }

    /// <summary>Numbers of the points that the job leaves out; none in reports of earlier versions.</summary>
    public IReadOnlyList<string> Without { get; init; } = [];

    /// <summary>The motion of the whole piece that explains the most of the errors; null if the points do not tell it or were aligned, and
    /// in older reports.</summary>
    public required SurfaceMotion? Motion { get; init; }

    /// <summary>The stage after which the surface was measured: finishing or semi-finishing.</summary>
    public required CuttingStage Stage { get; init; }

    /// <summary>Statistics of the measured errors.</summary>
    public required DeviationStatistics Before { get; init; }

    /// <summary>Whether the errors have a structure, and which tests found one. The document does not contain the variance, and nothing but
    /// the verdict if that is undetermined.</summary>
    public required SpatialStructure Structure { get; init; }

    /// <summary>True if each place is moved by its own error, false if all by the mean error, as with a modified tool radius.</summary>
    public required bool IsMirror { get; init; }

    /// <summary>The share of the error that is compensated.</summary>
    public required double Gain { get; init; }

    /// <summary>The largest error that the job allows to compensate.</summary>
    public required double LimitMm { get; init; }

    /// <summary>True if the error was fitted, false if a surface was fitted to the compensation points.</summary>
    public required bool OfError { get; init; }

    /// <summary>Name of the method of fitting.</summary>
    public required string Fit { get; init; }

    /// <summary>The largest distance of the compensated surface from the nominal one.</summary>
    public required double LargestMoveMm { get; init; }

    /// <summary>Name of the model of the systematic error.</summary>
    public required string Model { get; init; }

    /// <summary>The fit of that model; null for a constant and for a surface through points.</summary>
    public required FindingsFit? FieldFit { get; init; }

    /// <summary>The surface to cut.</summary>
    public required FindingsSurface Surface { get; init; }

    /// <summary>The error that is expected to remain after mirroring.</summary>
    public required SurfacePrediction Mirror { get; init; }

    /// <summary>The error that is expected to remain with a modified tool radius.</summary>
    public required SurfacePrediction ToolRadius { get; init; }

    /// <summary>The error at each measured point, in the order of measuring.</summary>
    public required IReadOnlyList<ErrorSample> Samples { get; init; }

    /// <summary>The compensation point of each measured point.</summary>
    public required IReadOnlyList<Point3> Compensated { get; init; }

    /// <summary>Map of the error, and of what remains of it. The document does not contain heights.</summary>
    public required ErrorMap Map { get; init; }

    /// <summary>The lot with this piece, for the next compensation; null in older reports.</summary>
    public required MeasuredLot? Pieces { get; init; }

    /// <summary>What the lot says about the next piece; null for its first piece and in older reports.</summary>
    public required Lot? Lot { get; init; }

    /// <summary>The prediction for the chosen compensation.</summary>
    public SurfacePrediction Predicted => IsMirror ? Mirror : ToolRadius;

    /// <summary>The findings of a compensation.</summary>
    /// <param name="result">The compensation.</param>
    /// <param name="cutBy">The program that cut the measured piece.</param>
    public static SurfaceFindings Of(CompensationResult result, MeasuredPieceProgram cutBy)
    {
        ArgumentNullException.ThrowIfNull(result);
        var (job, map) = (result.Input.Job, ErrorMap.Of(result));
        return new()
        {
            Verdict = result.Verdict(map),
            CutBy = cutBy,
            Without = [.. job.Measuring.Without.Select(ReportNumber.Count)],
            Alignment = result.Alignment,
            Motion = result.Motion,
            Stage = job.Measuring.After,
            Before = result.Before,
            Structure = result.Structure,
            IsMirror = job.Compensation.Mirror,
            Gain = job.Compensation.Gain,
            LimitMm = job.Compensation.LimitMm,
            OfError = job.Fit.OfError,
            Fit = job.Fit.Method.Name,
            LargestMoveMm = result.LargestMoveMm,
            Model = result.Systematic switch
            {
                FittedField fitted => FieldWords.Of(fitted.Kind),
                ConstantField => "constant",
                _ => "surface-fit",
            },
            FieldFit = result.Systematic is FittedField field ? FindingsFit.Of(field) : null,
            Surface = FindingsSurface.Of(result),
            Mirror = result.Mirror,
            ToolRadius = result.ToolRadius,
            Samples = result.Samples,
            Compensated = [.. result.Expected.Select(result.PointOf)],
            Map = map,
            Pieces = result.Pieces,
            Lot = result.Lot,
        };
    }

    /// <summary>Writes the members into the open object.</summary>
    public void Write(ReportWriter json)
    {
        ArgumentNullException.ThrowIfNull(json);
        if (Verdict is { } verdict)
        {
            json.Object("verdict", () => verdict.Write(json));
        }

        json.Object("cutBy", () =>
        {
            json.Text("known", CutBy.File is null ? "assumed" : "named");
            json.Text("file", CutBy.File);
            json.Text("sha256", CutBy.Sha256);
            if (CutBy.Previous is { } previous)
            {
                json.Text("previous", previous);
            }
        });
        json.Texts("without", Without);
        EvaluationReportJson.Alignment(json, Alignment);
        if (Motion is { } motion)
        {
            json.Object("commonMotion", () => motion.Write(json));
        }

        json.Text("stage", MeasuredStage.Name(Stage));
        json.Object("before", () => EvaluationReportJson.Statistics(json, Before));
        json.Object("structure", () => StructureJson.Write(json, Structure));
        json.Object("compensation", () =>
        {
            json.Text("method", Method(IsMirror));
            json.Number("gain", Gain);
            json.Number("limitMm", LimitMm);
            json.Text("of", OfError ? "error" : "points");
            json.Text("fit", Fit);
            json.Number("largestMoveUm", LargestMoveMm * 1000);
            json.Text("model", Model);
            FieldFit?.Write(json);
        });
        json.Object("surface", () => Surface.Write(json));
        json.Object("predicted", () =>
        {
            json.Object("mirror", () => WritePrediction(json, Mirror));
            json.Object("toolRadius", () => WritePrediction(json, ToolRadius));
        });
        json.List("points", Enumerable.Range(0, Samples.Count), i => WritePoint(json, i));
        json.Object("map", () => MapJson.Write(json, Map));
        if (Pieces is not null)
        {
            json.Object("lot", () => LotJson.Write(json, Pieces, Lot));
        }
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    /// <returns>The findings; null if the document is older than the map.</returns>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static SurfaceFindings? Read(ReportReader json)
    {
        ArgumentNullException.ThrowIfNull(json);
        if (json.OptionalObject("map") is not { } map)
        {
            return null;
        }

        var (cutBy, compensation, predicted) = (json.OptionalObject("cutBy"), json.Object("compensation"), json.Object("predicted"));
        var points = json.List("points", ReadPoint);
        var (pieces, lot) = LotJson.Read(json);
        return new()
        {
            CutBy = new(cutBy?.OptionalText("file"), cutBy?.OptionalText("sha256")) { Previous = cutBy?.OptionalText("previous") },
            Verdict = json.OptionalObject("verdict") is { } verdict ? SurfaceVerdict.Read(verdict) : null,
            Without = json.OptionalTexts("without"),
            Alignment = EvaluationReportJson.ReadAlignment(json),
            Motion = json.OptionalObject("commonMotion") is { } motion ? SurfaceMotion.Read(motion) : null,
            Stage = json.Word("stage", [CuttingStage.SemiFinishing, CuttingStage.Finishing], MeasuredStage.Name),
            Before = EvaluationReportJson.ReadStatistics(json.Object("before")),
            Structure = StructureJson.Read(json.Object("structure")),
            IsMirror = compensation.Word("method", [true, false], Method),
            Gain = compensation.Number("gain"),
            LimitMm = compensation.Number("limitMm"),
            OfError = compensation.Word("of", [true, false], e => e ? "error" : "points"),
            Fit = compensation.Text("fit"),
            LargestMoveMm = compensation.Micrometers("largestMoveUm"),
            Model = compensation.Text("model"),
            FieldFit = FindingsFit.Read(compensation),
            Surface = FindingsSurface.Read(json.Object("surface")),
            Mirror = ReadPrediction(predicted.Object("mirror"), Method(true), [.. points.Select(p => p.MirrorMm)]),
            ToolRadius = ReadPrediction(predicted.Object("toolRadius"), Method(false), [.. points.Select(p => p.ToolRadiusMm)]),
            Samples = [.. points.Select(p => p.Sample)],
            Compensated = [.. points.Select(p => p.Compensated)],
            Map = MapJson.Read(map),
            Pieces = pieces,
            Lot = lot,
        };
    }

    private static string Method(bool isMirror) => isMirror ? "mirror" : "tool-radius";

    private static void WritePrediction(ReportWriter json, SurfacePrediction prediction)
    {
        EvaluationReportJson.Statistics(json, prediction.Statistics);
        json.Number("meanUncertaintyUm", prediction.MeanUncertaintyMm * 1000);
        json.Number("pointUncertaintyUm", prediction.PointUncertaintyMm * 1000);
    }

    private static SurfacePrediction ReadPrediction(ReportReader json, string method, IReadOnlyList<double> errors) => new(
        method,
        errors,
        EvaluationReportJson.ReadStatistics(json),
        json.Micrometers("meanUncertaintyUm"),
        json.Micrometers("pointUncertaintyUm"));

    private void WritePoint(ReportWriter json, int index)
    {
        var (sample, compensated) = (Samples[index], Compensated[index]);
        json.Count("point", sample.Point);
        json.Count("i", sample.I);
        json.Count("j", sample.J);
        json.Number("u", sample.U);
        json.Number("v", sample.V);
        json.Numbers("nominal", [sample.Nominal.X, sample.Nominal.Y, sample.Nominal.Z]);
        json.Numbers("normal", [sample.Normal.X, sample.Normal.Y, sample.Normal.Z]);
        json.Number("errorUm", sample.ErrorMm * 1000);
        json.Number("predictedUm", Predicted.Errors[index] * 1000);
        json.Number("mirrorUm", Mirror.Errors[index] * 1000);
        json.Number("toolRadiusUm", ToolRadius.Errors[index] * 1000);
        json.Numbers("compensated", [compensated.X, compensated.Y, compensated.Z]);
    }

    private static (ErrorSample Sample, double MirrorMm, double ToolRadiusMm, Point3 Compensated) ReadPoint(ReportReader json) => (
        new(
            json.Count("point"),
            json.Count("i"),
            json.Count("j"),
            json.Number("u"),
            json.Number("v"),
            json.Point3("nominal"),
            json.Vector3("normal"),
            json.Micrometers("errorUm")),
        json.Micrometers("mirrorUm"),
        json.Micrometers("toolRadiusUm"),
        json.Point3("compensated"));
}

/// <summary>Writes the map of an error into a report, and reads it.</summary>
internal static class MapJson
{
    /// <summary>Writes it into the open object, without the heights of the places.</summary>
    public static void Write(ReportWriter json, ErrorMap map)
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

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    public static ErrorMap Read(ReportReader json)
    {
        var (countU, countV) = ((long)json.Count("countU"), (long)json.Count("countV"));
        var places = json.Numbers("x", countU * countV).Zip(json.Numbers("y", countU * countV), (x, y) => new Point3(x, y, 0));
        var outside = json.Counts("outside");
        if (countU < 2 || countV < 2)
        {
            throw json.Refusal(countU < 2 ? "countU" : "countV", "too-small", "at least 2");
        }

        return outside.Any(c => c >= (countU - 1) * (countV - 1))
            ? throw json.Refusal("outside", "too-large", "numbers of cells")
            : new(new((int)countU, (int)countV, [.. places], outside), Mm("errorUm"), Mm("mirrorUm"), Mm("toolRadiusUm"));

        double[] Mm(string name) => [.. json.Numbers(name, countU * countV).Select(e => e / 1000)];
    }
}
