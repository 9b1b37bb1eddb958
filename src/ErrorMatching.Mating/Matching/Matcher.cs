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

        var part = AlignedMeasurement.Align(job, maps, input.Theoretical, input.Part, MeasuredPiece.Part);
        var counterpart = input.Counterpart is null
            ? null
            : AlignedMeasurement.Align(job, maps, input.Theoretical, input.Counterpart, MeasuredPiece.Counterpart);
        CounterpartLot? lot = null;
        if (job.Compensation.From == CompensationSource.Counterpart)
        {
            var following = CounterpartLot.Add(
                job, maps, input.Theoretical, counterpart!, input.Previous, input.Latest, input.ToolChanged);
            if (following.Result is null)
            {
                return Outcome.Refused<MatchResult>(following.Refusals);
            }

            lot = following.Result;
        }

        var runs = new BoundaryRuns(job, path, maps, input.Theoretical);
        var decision = Decider.Decide(job, BoundaryPoints(input, runs, part, counterpart, lot), lot);
        if (!decision.IsUsable)
        {
            return Outcome.Refused<MatchResult>(decision.Refusals);
        }

        var known = new Known(input, runs, part, counterpart, lot, decision);
        return decision.Compensates ? Compensate(known) : Unchanged(known);
    }

    // What is known before anything is corrected.
    private sealed record Known(
        MatchInput Input,
        BoundaryRuns Runs,
        AlignedMeasurement Part,
        AlignedMeasurement? Counterpart,
        CounterpartLot? Lot,
        MatingDecision Decision)
    {
        public NcPath Path => Runs.Path;

        public IReadOnlyList<FeatureMap> Maps => Runs.Maps;

        public Marker Marker => new(Input.Compensated.Sha256, Path.Sha256);

        public CourseEstimator Estimator() => new(Runs, Decision);

        public OffsetChooser Chooser(PieceEstimate piece, NcPath? after) => new(
            Input.Job, Path, Maps, Decision, piece, after, OffsetsBefore(Input), OffsetsFile(Input, Path), Marker);

        // What the cuts leave of the piece as it was measured.
        public MatchResult Result(
            PieceEstimate piece, Func<RunEstimate, RunPath> cuts, NcPath after, NcProof proof, CourseEstimate? course, Marker? marker) =>
            new(
                Input, Path, after, Maps, Part, Counterpart, Decision, piece.PredictOn(cuts), course?.Wish, course?.Rewrite, marker, proof)
            {
                Trust = MeasurementTrust.Judge(Input.Job, piece.Runs, Decision),
                Pair = PairEstimator.Estimate(Input.Job, Path, Maps, piece, cuts),
            };

        // The program as it is, which nothing changes.
        public MatchResult Original(PieceEstimate piece, Func<RunEstimate, RunPath> cuts)
        {
            var nothing = DisplacementWish.OfElements([]);
            var proof = Prover.Check(Path, Path.Program, nothing, Elementary.Pow(10, -Path.Dialect.MetricDecimals));
            return Result(piece, cuts, Path, proof, null, null);
        }

        public MatchResult WithOffset(CorrectionChoice correction, PieceEstimate piece, Func<RunEstimate, RunPath> cuts)
        {
            var result = Original(piece, cuts);
            return result with { Lot = After(Lot, result.Prediction), Correction = correction };
        }
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
        BoundaryRuns runs,
        AlignedMeasurement part,
        AlignedMeasurement? counterpart,
        CounterpartLot? lot)
    {
        var number = 0;
        var isFollowed = lot?.Next is null ? null : PartIsFollowed(input, runs.Maps, part);
        return [.. runs.Maps.Select((map, f) => (IReadOnlyList<BoundaryPoint>)[.. map.Feature.Points.Select((label, i) =>
        {
            var design = ProjectedPoint.Of(input.Theoretical[label], map.Feature.Plane, input.Theoretical.File).Position;
            var present = lot is null ? design
                : lot.ExpectedMm(number++) is { } expected ? design + (expected * map.Normals[i])
                : counterpart!.Points[label];
            var gap = map.Feature.GapMm;

            // Where the program cuts elsewhere than it should, and the job wants that corrected.
            var baseMm = map.Feature.CorrectsBase ? runs.BaseMm(f, i) : 0;
            present += baseMm * map.Normals[i];
            return new BoundaryPoint(label, present, part.Points[label] - (gap * map.Normals[i]), map.Normals[i])
            {
                GapMm = gap,
                BaseMm = baseMm,
                IgnoredMm = isFollowed?[f] ?? true ? 0 : (part.Points[label] - design).Dot(map.Normals[i]),
            };
        })])];
    }

    // Whether a feature of the part is off its design by more than its measurement may show.
    private static bool[] PartIsFollowed(MatchInput input, IReadOnlyList<FeatureMap> maps, AlignedMeasurement part)
    {
        var u = input.Job.Gauge.Uncertainty.CombinedMm;
        var features = maps.Select(map => map.Feature.Points.Select((label, i) =>
        {
            var design = ProjectedPoint.Of(input.Theoretical[label], map.Feature.Plane, input.Theoretical.File).Position;
            return new SignificantPoint(design, map.Normals[i], (part.Points[label] - design).Dot(map.Normals[i]));
        }).ToArray()).ToArray();
        var factor = Significance.Factor([.. features.Select(f => (ToleranceBand.Zero, f.Length))], u);
        bool[] alone = [.. features.Select(f => f.Any(p => Math.Abs(p.Mm) > factor * u))];
        return Significance.Together(features, alone, u, input.Job.Gauge.Uncertainty.SharedMm);
    }

    private static Outcome<MatchResult> Compensate(Known known)
    {
        var (path, job) = (known.Path, known.Input.Job);
        var estimator = known.Estimator();
        var outcome = estimator.Estimate();
        if (!outcome.IsUsable)
        {
            // An offset that brings the boundary to where it should be may do what blocks cannot.
            return ByOffset(known, estimator.Measure()) ?? Named(outcome.Refusal, known.Maps);
        }

        var (wish, rewrite) = (outcome.Result.Wish, outcome.Result.Rewrite);
        if (rewrite.Patches.Count == 0)
        {
            // Every correction is less than half an increment, so the program is already right.
            return Unchanged(known);
        }

        var marker = known.Marker;
        var program = NcProgram.Read(marker.InsertInto(rewrite.Program), path.Dialect.Syntax);
        var proof = Prover.Check(path, program, wish, rewrite.LeastIncrementMm, marker.TextIn(path.Dialect.Syntax));
        if (!proof.Holds)
        {
            return Outcome.Refused<MatchResult>([.. proof.Failures.Select(f => Named(f, known.Maps))]);
        }

        var after = NcInterpreter.Run(program, path);
        var piece = estimator.Measure(outcome.Result, after);
        CorrectionChoice? correction = null;
        if (job.Correction.AllowsOffsets)
        {
            var chooser = known.Chooser(piece, after);
            correction = chooser.Choose(compensates: true);
            if (correction.IsOffset)
            {
                return known.WithOffset(correction, piece, chooser.Chosen!);
            }

            if (!job.Correction.Allows(CorrectionKind.Blocks))
            {
                return Insufficient(correction);
            }
        }

        var result = known.Result(piece, r => r.Run.On(after), after, proof, outcome.Result, marker);
        return result with { Lot = After(known.Lot, result.Prediction), Correction = correction };
    }

    private static CounterpartLot? After(CounterpartLot? lot, MatingPrediction prediction) =>
        lot?.After(prediction.Features.SelectMany(f => f.Points.Select(p => p.AfterMm - p.BeforeMm)));

    private static Outcome<MatchResult>? ByOffset(Known known, PieceEstimate piece)
    {
        var job = known.Input.Job;
        if (!job.Correction.AllowsOffsets || job.Compensation is not { Gain: 1, Amount: CompensationAmount.Whole })
        {
            return null;
        }

        var chooser = known.Chooser(piece, null);
        return chooser.Choose(compensates: true) is { IsOffset: true } correction
            ? (Outcome<MatchResult>)known.WithOffset(correction, piece, chooser.Chosen!)
            : null;
    }

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

    private static Outcome<MatchResult> Unchanged(Known known)
    {
        var piece = known.Estimator().Measure();
        var correction = known.Input.Job.Correction.AllowsOffsets ? known.Chooser(piece, known.Path).Choose(compensates: false) : null;
        return known.Original(piece, r => r.Run.On(known.Path)) with { Lot = known.Lot, Correction = correction };
    }
}
