using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The pure core: computes a program with its proof, or a refusal, from job, measurement and base program. Independent of clock,
/// disk and culture.</summary>
public static class Matcher
{
    /// <summary>Computes a match.</summary>
    /// <exception cref="InputException">A measurement lacks a point or coordinate.</exception>
    /// <exception cref="GeometryException">Points do not determine a feature or the alignment; the message names it.</exception>
    /// <exception cref="InputException">The dialect or a selector cannot be read.</exception>
    public static Outcome<MatchResult> Match(MatchInput input)
    {
        ArgumentNullException.ThrowIfNull(input);
        var job = input.Job;
        var path = input.Interpret();
        if (CheckBefore(input, path) is { } refusal)
        {
            return refusal;
        }

        if (FeatureMapper.Map(job, path, input.Theoretical, out var maps) is { } unmapped)
        {
            return unmapped;
        }

        if (CompensatedPath.Check(path) is { } stop && CompensatedPath.Stops(stop))
        {
            return Named(stop, maps);
        }

        var part = AlignedMeasurement.Of(job, maps, input.Theoretical, input.Part, MeasuredPiece.Part);
        var counterpart = input.Counterpart is null
            ? null
            : AlignedMeasurement.Of(job, maps, input.Theoretical, input.Counterpart, MeasuredPiece.Counterpart);
        CounterpartLot? lot = null;
        if (job.Compensation.From == CompensationSource.Counterpart)
        {
            var following = CounterpartLot.Of(job, maps, input.Theoretical, counterpart!, input.Previous);
            if (following.Result is null)
            {
                return Outcome.Refused<MatchResult>(following.Refusals);
            }

            lot = following.Result;
        }

        var decision = Decider.Decide(job, BoundaryPoints(input, maps, part, counterpart, lot), lot?.UncertaintyMm(job));
        if (!decision.IsUsable)
        {
            return Outcome.Refused<MatchResult>(decision.Refusals);
        }

        return decision.Compensates
            ? Compensate(input, path, maps, part, counterpart, lot, decision)
            : Unchanged(input, path, maps, part, counterpart, lot, decision);
    }

    private static Refusal? CheckBefore(MatchInput input, NcPath path)
    {
        foreach (var (block, marker) in Marker.Find(path.Program))
        {
            var name = path.Program.NameOf(path.Program[block]);
            if (Refused(input, marker) is var (code, why))
            {
                return new(code, $"{name}: {why}", new() { Block = name, Line = block + 1 });
            }
        }

        return path.Refusal
            ?? UnitCheck.Refuse(input.Job, input.Theoretical, input.Part, input.Counterpart)
            ?? ColumnCheck.Refuse(input.Job, input.Theoretical, input.Part, input.Counterpart)
            ?? OriginCheck.Refuse(input.Job.OriginCheck, input.Theoretical, input.Part, input.Counterpart)
            ?? AlignedMeasurement.Check(input.Job);
    }

    // Why a program with this marker must not be compensated, or null.
    private static (string Code, string Why)? Refused(MatchInput input, Marker? marker) => marker switch
    {
        _ when input.Job.Compensation.From == CompensationSource.Part =>
            (
                Marker.AlreadyCompensated,
                "the program carries a marker, so it is already compensated and not the nominal one. Start from the nominal program."),
        null =>
            (
                Marker.MarkerDamaged,
                "the marker was changed and cannot be read, so the program may already follow this measurement. Start from the program "
                    + "as it was written."),
        _ when marker.MeasurementSha256 == input.Compensated.Sha256 =>
            (
                Marker.SameMeasurement,
                "the program already follows this very measurement of the counterpart. Measure the piece that this program cut."),
        _ => null,
    };

    private static List<IReadOnlyList<BoundaryPoint>> BoundaryPoints(
        MatchInput input,
        IReadOnlyList<FeatureMap> maps,
        AlignedMeasurement part,
        AlignedMeasurement? counterpart,
        CounterpartLot? lot)
    {
        var number = 0;
        return [.. maps.Select(map => (IReadOnlyList<BoundaryPoint>)[.. map.Feature.Points.Select((label, i) =>
        {
            var design = ProjectedPoint.Of(input.Theoretical[label], map.Feature.Plane, input.Theoretical.File).Position;
            var present = lot is null ? design
                : lot.ExpectedMm(number++) is { } expected ? design + (expected * map.Normals[i])
                : counterpart!.Points[label];
            return new BoundaryPoint(label, present, part.Points[label], map.Normals[i]);
        })])];
    }

    private static Outcome<MatchResult> Compensate(
        MatchInput input,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        AlignedMeasurement part,
        AlignedMeasurement? counterpart,
        CounterpartLot? lot,
        MatingDecision decision)
    {
        var estimator = new CourseEstimator(input.Job, path, maps, decision, input.Theoretical);
        var outcome = estimator.Estimate();
        if (!outcome.IsUsable)
        {
            return ByOffset(input, path, maps, part, counterpart, lot, decision, estimator) ?? Named(outcome.Refusal, maps);
        }

        var (wish, rewrite) = (outcome.Result.Wish, outcome.Result.Rewrite);
        if (rewrite.Patches.Count == 0)
        {
            // Every correction is less than half an increment, so the program is already right.
            return Unchanged(input, path, maps, part, counterpart, lot, decision);
        }

        var marker = MarkerOf(input, path);
        var program = NcProgram.Read(marker.InsertInto(rewrite.Program), path.Dialect.Syntax);
        var proof = Prover.Check(path, program, wish, rewrite.LeastIncrementMm, marker.TextIn(path.Dialect.Syntax));
        if (!proof.Holds)
        {
            return Outcome.Refused<MatchResult>([.. proof.Failures.Select(f => Named(f, maps))]);
        }

        var after = NcInterpreter.Run(program, path);
        var prediction = estimator.Predict(after);
        var pair = Pair(input, path, maps, estimator, r => r.OnCuts(after));
        CorrectionChoice? correction = null;
        if (input.Job.Correction.AllowsOffsets)
        {
            var chooser = new OffsetChooser(
                input.Job, path, maps, decision, estimator, after, OffsetsBefore(input), OffsetsFile(input, path), marker);
            correction = chooser.Choose(compensates: true);
            if (correction.IsOffset)
            {
                return WithOffset(input, path, maps, part, counterpart, lot, decision, correction, estimator, chooser.Chosen!);
            }

            if (!input.Job.Correction.Allows(CorrectionKind.Blocks))
            {
                return Insufficient(correction);
            }
        }

        return new MatchResult(
                input,
                path,
                after,
                maps,
                part,
                counterpart,
                decision,
                prediction,
                wish,
                rewrite,
                marker,
                proof)
        {
            Lot = After(lot, prediction),
            Correction = correction,
            Pair = pair,
        };
    }

    private static PairAssembly? Pair(
        MatchInput input,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        CourseEstimator estimator,
        Func<RunEstimate, RunPath> cuts) =>
        PairEstimator.Of(path, maps, estimator, input.Job.Counterpart.Frame.Inverse(), cuts);

    private static MatchResult WithOffset(
        MatchInput input,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        AlignedMeasurement part,
        AlignedMeasurement? counterpart,
        CounterpartLot? lot,
        MatingDecision decision,
        CorrectionChoice correction,
        CourseEstimator estimator,
        Func<RunEstimate, RunPath> cuts)
    {
        var prediction = estimator.PredictOn(cuts);
        return Original(
            input, path, maps, part, counterpart, After(lot, prediction), decision, correction, prediction,
            Pair(input, path, maps, estimator, cuts));
    }

    private static CounterpartLot? After(CounterpartLot? lot, MatingPrediction prediction) =>
        lot?.After(prediction.Features.SelectMany(f => f.Points.Select(p => p.AfterMm - p.BeforeMm)));

    // Blocks cannot follow; an offset that brings the boundary to where it should be may.
    private static Outcome<MatchResult>? ByOffset(
        MatchInput input,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        AlignedMeasurement part,
        AlignedMeasurement? counterpart,
        CounterpartLot? lot,
        MatingDecision decision,
        CourseEstimator estimator)
    {
        if (!input.Job.Correction.AllowsOffsets || input.Job.Compensation is not { Gain: 1, Amount: CompensationAmount.Whole })
        {
            return null;
        }

        estimator.Predict(path);
        var chooser = new OffsetChooser(
            input.Job, path, maps, decision, estimator, null, OffsetsBefore(input), OffsetsFile(input, path), MarkerOf(input, path));
        return chooser.Choose(compensates: true) is { IsOffset: true } correction
            ? (Outcome<MatchResult>)WithOffset(
                input, path, maps, part, counterpart, lot, decision, correction, estimator, chooser.Chosen!)
            : null;
    }

    private static Marker MarkerOf(MatchInput input, NcPath path) => new(input.Compensated.Sha256, path.Sha256);

    // In feedback the counterpart was cut with the offsets of the match before. In feed-forward each piece starts from none.
    private static OffsetTotals? OffsetsBefore(MatchInput input) =>
        input.Job.Compensation.From == CompensationSource.Counterpart ? input.Previous?.Offsets ?? OffsetTotals.None : null;

    private static string OffsetsFile(MatchInput input, NcPath path) =>
        input.OffsetsFile ?? OffsetProgram.FileBeside(path.Dialect, input.ProgramFile);

    private static Outcome<MatchResult> Insufficient(CorrectionChoice correction) => new Refusal(
        "offset-insufficient",
        $"no offset that the job allows is enough: {string.Join("; ", correction.Refused.Select(r => r.Reason))}. Allow blocks, or another "
            + "offset.",
        new());

    // Adds the name of the feature that owns the refused block, if any.
    private static Refusal Named(Refusal refusal, IReadOnlyList<FeatureMap> maps) =>
        refusal.Place.Feature is not null ? refusal
            : FeatureRefusal.Of(
                refusal, maps.FirstOrDefault(m => refusal.Place.Line is { } line && m.Blocks.Contains(line - 1))?.Feature.Name);

    private static Outcome<MatchResult> Unchanged(
        MatchInput input,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        AlignedMeasurement part,
        AlignedMeasurement? counterpart,
        CounterpartLot? lot,
        MatingDecision decision)
    {
        var estimator = new CourseEstimator(input.Job, path, maps, decision, input.Theoretical);
        var prediction = estimator.Predict(path);
        var pair = Pair(input, path, maps, estimator, r => r.OnCuts(path));
        var correction = !input.Job.Correction.AllowsOffsets
            ? null
            : new OffsetChooser(
                input.Job, path, maps, decision, estimator, path, OffsetsBefore(input), OffsetsFile(input, path), MarkerOf(input, path))
                .Choose(compensates: false);
        return Original(input, path, maps, part, counterpart, lot, decision, correction, prediction, pair);
    }

    private static MatchResult Original(
        MatchInput input,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        AlignedMeasurement part,
        AlignedMeasurement? counterpart,
        CounterpartLot? lot,
        MatingDecision decision,
        CorrectionChoice? correction,
        MatingPrediction prediction,
        PairAssembly? pair)
    {
        var nothing = DisplacementWish.OfElements([]);
        var proof = Prover.Check(path, path.Program, nothing, Elementary.Pow(10, -path.Dialect.MetricDecimals));
        return new(input, path, path, maps, part, counterpart, decision, prediction, null, null, null, proof)
        {
            Lot = lot,
            Correction = correction,
            Pair = pair,
        };
    }
}
