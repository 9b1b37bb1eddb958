using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Creates the report of a match.</summary>
public static class MatchReporter
{
    /// <summary>Creates the report.</summary>
    /// <param name="result">The match.</param>
    /// <param name="programFile">Path of the program to cut, which may not be written yet.</param>
    /// <param name="calculatingS">Duration of the calculation, because the core has no clock; null if it was not timed.</param>
    /// <exception cref="GeometryException">The points of a feature do not determine it; the message names it.</exception>
    public static MatchReport Report(MatchResult result, string programFile, double? calculatingS)
    {
        ArgumentNullException.ThrowIfNull(result);
        var (job, input) = (result.Input.Job, result.Input);
        var evaluations = result.Maps.Select(m => Evaluate(result, m)).ToArray();
        double?[] after = [.. result.Prediction.Features.Select((f, i) => ProbabilityAfter(result.Maps[i], f))];
        return new()
        {
            Job = new(job.Name, job.WorkOrder, job.File, job.Sha256),
            Inputs = Inputs(input, result.Before),
            Alignments = [
                .. new[]
                {
                    ("part", result.Part),
                    ("counterpart", result.Counterpart)
                }.Where(p => p.Item2 is not null).Select(p => Alignment(job, p.Item1, p.Item2!))],
            OriginCheck = job.OriginCheck is { } check
                ? OriginCheck.Check(check, input.Theoretical[check.Point], input.Compensated[check.Point])
                : null,
            Compensation = job.Compensation,
            Rule = job.Rule,
            ProbabilityBefore = result.Decision.ProbabilityBefore,
            ProbabilityAfter = Conformance.OfIndependent(after),
            Trust = result.Trust,
            Without = job.Without,
            Uncertainty = job.Gauge.Uncertainty,
            Chain = job.Chain is { } chain ? ReportChain.Of(chain) : null,
            Features = [.. result.Maps.Select((map, i) => Feature(result, map, i, evaluations[i]))],
            KeyPoints = [.. result.Maps.SelectMany((map, i) => KeyPoints(result, map, i))],
            Pair = result.Pair,
            Program = Program(result, programFile),
            Proof = Proof(result.Proof),
            Time = new(job.Gauge.Measuring.TotalS(job.KeyPoints.Count), calculatingS),
            RadiusWearMm = UniformOffset.RadiusWearMm(result.Decision),
            Correction = result.Correction is { } correction
                ? Correction(correction, result.Input, result.Before.Dialect, programFile)
                : null,
            Lot = result.Lot,
            Warnings = [.. evaluations.SelectMany(e => e.Warnings), .. Warnings(result)],
            Notes = Notes(result),
        };
    }

    // The program of the offsets is written beside the program to cut.
    private static ReportCorrection Correction(CorrectionChoice choice, MatchInput input, NcDialect dialect, string programFile)
    {
        if (choice.Program is not { } program)
        {
            return new(choice, null, null);
        }

        var name = input.OffsetsFile ?? OffsetProgram.FileBeside(dialect, input.ProgramFile);
        return new(choice, PathText.Beside(programFile, name), ContentHash.Sha256(program))
        {
            Call = OffsetProgram.CallOf(dialect, name, input.Job.Correction.ProgramNumber),
        };
    }

    private static double? ProbabilityAfter(FeatureMap map, FeaturePrediction predicted) =>
        Conformance.OfIndependent(predicted.Points.Select(p => ProbabilityAfter(map, p)));

    private static double? ProbabilityAfter(FeatureMap map, PredictedError predicted) =>
        Conformance.Probability(map.Feature.Tolerance.Band.Opposite(), predicted.AfterMm, predicted.StandardUncertaintyMm);

    private static FeatureEvaluation Evaluate(MatchResult result, FeatureMap map) => FeatureEvaluator.Evaluate(
        map.Feature,
        Theoretical(result, map),
        [.. map.Feature.Points.Select(l => result.Part.Points[l])],
        result.Input.Job.Gauge.Uncertainty.CombinedMm);

    private static Point2[] Theoretical(MatchResult result, FeatureMap map) =>
        [
            .. map.Feature.Points.Select(
                l => ProjectedPoint.Of(result.Input.Theoretical[l], map.Feature.Plane, result.Input.Theoretical.File).Position)];

    private static List<ReportInput> Inputs(MatchInput input, NcPath path)
    {
        var inputs = new List<ReportInput>
        {
            new("theoretical", input.Theoretical.File, input.Theoretical.Sha256),
            new("part", input.Part.File, input.Part.Sha256),
        };
        if (input.Counterpart is { } counterpart)
        {
            inputs.Add(new("counterpart", counterpart.File, counterpart.Sha256));
        }

        inputs.Add(new("program", input.ProgramFile, input.ProgramSha256));
        inputs.AddRange(path.CalledPrograms.Select(c => new ReportInput("called", c.Name, c.Sha256)));
        if (input.Previous is { } previous)
        {
            inputs.Add(new("previous", previous.File, previous.Sha256));
        }

        if (input.Latest is { } latest)
        {
            inputs.Add(new("latest", latest.File, latest.Sha256));
        }

        inputs.AddRange(input.OwnDialect?.Files.Select(f => new ReportInput("dialect", f.File, f.Sha256)) ?? []);
        return inputs;
    }

    private static ReportAlignment Alignment(MatingJob job, string role, AlignedMeasurement aligned) => new(
        role,
        job.Alignment.Kind,
        aligned.Alignment.Transform,
        aligned.Alignment.Rms,
        aligned.Alignment.Max,
        [.. job.KeyPoints.Select((label, i) => new ReportResidual(label, aligned.Alignment.Residuals[i]))]);

    private static ReportFeature Feature(MatchResult result, FeatureMap map, int index, FeatureEvaluation evaluation)
    {
        var (job, decision, predicted) = (result.Input.Job, result.Decision.Features[index], result.Prediction.Features[index]);
        var heights = result.Part.StandsOut.Where(s => map.Feature.Points.Contains(s.Label)).Select(s => Math.Abs(s.Millimeters)).ToArray();
        return new()
        {
            Name = map.Feature.Name,
            Kind = map.Feature.Kind,
            Tolerance = map.Feature.Tolerance,
            Quantities = [.. Quantities(result, map, index, evaluation)],
            GapMm = map.Feature.GapMm,
            CorrectsBase = map.Feature.CorrectsBase,
            BaseMm = job.Compensation.From == CompensationSource.Part ? predicted.Points.Select(p => p.BaseMm).MaxBy(Math.Abs) : null,
            Decision = decision.Decision,
            LargestMm = decision.LargestMm,
            UncertaintyMm = decision.StandardUncertaintyMm,
            Acceptance = decision.Acceptance,
            SignificantMm = decision.SignificantMm,
            IsSignificantTogether = decision.IsSignificantTogether,
            ProbabilityBefore = decision.ProbabilityBefore,
            ProbabilityAfter = ProbabilityAfter(map, predicted),
            ResidualsMm = evaluation.ResidualsMm,
            Curve = evaluation.Curve is { } curve ? ReportCurve.Of(curve) : null,
            TheoreticalOutline = Outlines.Boundary(job.Counterpart, result.Before, map.Passes[0]),
            CorrectedOutline = result.Correction is { IsOffset: true } offset
                ? Outlines.Boundary(job.Counterpart, result.Before, map.Passes[0], _ => offset.StepRadiusMm, offset.StepMove)
                : Outlines.Boundary(job.Counterpart, result.After, map.Passes[0]),
            ActualOutline = map.Feature.MeasuredOutline(
                new(
                    job.Counterpart,
                    result.Before,
                    map,
                    Theoretical(result, map),
                    [.. map.Feature.Points.Select(l => result.Part.Points[l])])
                {
                    Deviation = predicted.Deviation
                }),
            WorstBetween = predicted.WorstBetween,
            Priors = predicted.Priors,
            StandsOutMm = map.Feature.Points.All(l => result.Input.Part[l].HasZ) ? heights.DefaultIfEmpty().Max() : null,
        };
    }

    // Corrected: the same quantity, from key points on the original program's boundary (as designed, or as measured on the counterpart
    // that it cut), moved as the new program moves it.
    private static IEnumerable<ReportQuantity> Quantities(
        MatchResult result, FeatureMap map, int index, FeatureEvaluation evaluation)
    {
        var (theoretical, decided) = (Theoretical(result, map), result.Decision.Features[index].Points);
        Point2[] corrected = [
            .. result.Prediction.Features[index].Points.Select(
                (p, i) => decided[i].Point.Present + (map.Normals[i] * (p.AfterMm - p.BeforeMm)))];
        var after = FeatureEvaluator.Evaluate(map.Feature, theoretical, corrected, 0).Quantities.ToDictionary(
            q => q.Name, q => q.Actual, StringComparer.Ordinal);
        return evaluation.Quantities.Select(q => new ReportQuantity(q, after.TryGetValue(q.Name, out var value) ? value : null));
    }

    private static IEnumerable<ReportKeyPoint> KeyPoints(MatchResult result, FeatureMap map, int feature)
    {
        var (job, decision) = (result.Input.Job, result.Decision.Features[feature]);
        var theoretical = Theoretical(result, map);
        for (var i = 0; i < theoretical.Length; i++)
        {
            var (label, point, index) = (map.Feature.Points[i], decision.Points[i], i);
            var predicted = result.Prediction.Features[feature].Points[i];
            yield return new()
            {
                Point = label,
                Feature = map.Feature.Name,
                Theoretical = theoretical[i],
                Actual = result.Part.Points[label],
                Counterpart = job.Compensation.From == CompensationSource.Counterpart ? result.Counterpart!.Points[label] : null,
                InProgram = job.Counterpart.Frame.Apply(theoretical[i]),
                Normal = map.Normals[i],
                Correction = job.Counterpart.Frame.Apply(point.Correction),
                DecidedMm = point.Point.DecidedMm,
                ExcessMm = point.ExcessMm,
                ProbabilityBefore = point.ProbabilityBefore,
                ProbabilityAfter = ProbabilityAfter(map, predicted),
                UncompensatedMm = predicted.BeforeMm,
                PredictedMm = predicted.AfterMm,
                Interval95Mm = predicted.Interval95Mm,
                Blocks = [
                    .. map.Passes.Select(
                        p => result.Before.Program.NameOf(result.Before.Program[result.Before.Motions[p.Feet[index].Motion].Block]))
                        .Distinct(StringComparer.Ordinal)],
            };
        }
    }

    private static ReportProgram Program(MatchResult result, string programFile) => new(
        programFile,
        ContentHash.Sha256(result.Program.Span),
        result.Rewrite?.ChangedBlocks.Count ?? 0,
        result.Rewrite?.ChangedWords ?? 0,
        result.Rewrite is { } rewrite ? BlockDifference.Of(result.Before.Program, rewrite) : []);

    private static ReportProof Proof(NcProof proof) => new(
        proof.Holds,
        proof.Motions,
        proof.MovedMotions,
        proof.Neighbors,
        proof.Marker,
        proof.MaxDeviationFromWantedMm,
        proof.UntouchedBytesIdentical);

    private static IEnumerable<ReportWarning> Warnings(MatchResult result)
    {
        foreach (var problem in result.Before.Problems)
        {
            var block = result.Before.Program.NameOf(result.Before.Program[problem.Block]);
            yield return new("nc-" + problem.Code, $"{block}: {problem.Message}", block, problem.Message);
        }

        foreach (var corner in InsideCorners.Find(result.Input.Job, result.Before, result.Maps))
        {
            yield return WarningForms.Warning(
                WarningForms.InsideCorner,
                BlockOf(corner.Before),
                BlockOf(corner.After),
                corner.RadiusMm.ToString("0.###", CultureInfo.InvariantCulture),
                corner.OverlapMm.ToString("0.000", CultureInfo.InvariantCulture),
                corner.MostDiameterMm.ToString("0.###", CultureInfo.InvariantCulture));
        }

        foreach (var foot in result.OnCorners.Where(_ => result.Decision.Compensates))
        {
            var block = result.Before.Program.NameOf(result.Before.Program[result.Before.Motions[foot.Motion].Block]);
            yield return WarningForms.Warning(WarningForms.PointOnCorner, foot.Label, block);
        }

        foreach (var point in ReachCheck.Unreached(result.Input.Job, result.Before, result.Maps, result.Input.Theoretical))
        {
            var block = result.Before.Program.NameOf(result.Before.Program[result.Before.Motions.BlockOf(point.Motion)]);
            yield return WarningForms.Warning(
                WarningForms.PointNotReached, point.Label, point.GapMm.ToString("0.000", CultureInfo.InvariantCulture), block);
        }

        foreach (var (feature, mm) in result.KeptBases)
        {
            yield return WarningForms.Warning(
                WarningForms.BaseDiffers, feature, mm.ToString("+0.000;-0.000", CultureInfo.InvariantCulture));
        }

        foreach (var (motion, radius) in RadiusCheck.Others(result.Input.Job, result.Before, result.Maps))
        {
            var block = result.Before.Program.NameOf(result.Before.Program[result.Before.Motions.BlockOf(motion)]);
            var tool = result.Input.Job.Counterpart.ToolDiameterMm / 2;
            yield return WarningForms.Warning(
                WarningForms.ToolRadiusDiffers,
                block,
                radius.ToString("0.###", CultureInfo.InvariantCulture),
                tool.ToString("0.###", CultureInfo.InvariantCulture));
        }

        if (result.Input.Job.Counterpart.ProgramSha256 is null && result.Input.Job.Features.SelectMany(f => f.Blocks)
            .FirstOrDefault(b => BlockSelector.Parse(b).IsByLine) is { } lines)
        {
            yield return WarningForms.Warning(WarningForms.LinesWithoutHash, lines, result.Input.ProgramSha256);
        }

        foreach (var warning in GaugeCapability.WarningsOf(result.Input.Job))
        {
            yield return warning;
        }

        if (result.Trust.Scatter is { IsTooMuch: true } scatter)
        {
            yield return WarningForms.Warning(
                WarningForms.UncertaintyContradicted,
                ReportNumber.Rough(scatter.Ratio),
                ReportNumber.Rough(scatter.From),
                ReportNumber.Rough(scatter.To));
        }

        foreach (var (form, values) in result.Lot?.Next is { } lot ? LotWords.Warnings(lot) : [])
        {
            yield return WarningForms.Warning(form, values);
        }

        string BlockOf(int motion) => result.Before.Program.NameOf(result.Before.Program[result.Before.Motions[motion].Block]);

        var rms = result.Part.Alignment.Rms;
        if (result.Input.Job.Alignment.Kind != JobAlignmentKind.None && result.Decision.Compensates)
        {
            var (kind, left) = (ReportWords.Of(result.Input.Job.Alignment.Kind), rms.ToString("0.000", CultureInfo.InvariantCulture));
            yield return WarningForms.Warning(WarningForms.Aligned, kind, left);
        }
    }

    private static List<string> Notes(MatchResult result)
    {
        List<string> notes = [.. result.Before.Notes.Select(n => n.Message)];
        foreach (var (label, height) in result.Part.StandsOut)
        {
            notes.Add(string.Create(
                CultureInfo.InvariantCulture, $"Point {label} stands {height:+0.000;-0.000} mm out of its feature's plane."));
        }

        if (result.Lot?.Next is { } lot)
        {
            notes.AddRange(LotWords.Notes(lot));
        }

        if (result.Trust.Scatter is { IsTooLittle: true } scatter)
        {
            notes.Add($"The points scatter by {ReportNumber.Rough(scatter.Ratio)} times the uncertainty that the job states "
                + $"({ReportNumber.Rough(scatter.From)} to {ReportNumber.Rough(scatter.To)}, 95 %). What all points share shows in no "
                + "scatter.");
        }

        foreach (var map in result.Maps.Where(m => m.Passes.Count > 1))
        {
            notes.Add($"{map.Feature.Name} is cut in {map.Passes.Count} passes; each is displaced alike.");
        }

        if (result is { Decision.Compensates: true, Rewrite: null, Correction: null or { IsOffset: false } })
        {
            notes.Add("Every correction is smaller than half the control's least increment: the program stays as it is.");
        }

        return notes;
    }
}
