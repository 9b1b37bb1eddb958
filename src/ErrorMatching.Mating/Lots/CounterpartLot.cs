using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The counterparts that were cut and measured one after the other, in feedback.</summary>
/// <remarks>The error of the process at a key point is where the counterpart is, less where its program puts it, along the normal.
/// A program that corrects what the last counterpart shows cuts the noise of that measurement into the next one. With several
/// counterparts, it corrects what is expected of the next one instead. That expectation has weighed the noise already, so it is followed
/// without a further test. What is not significant of the part's own deviations is not followed: its noise is the same for all
/// counterparts.</remarks>
/// <param name="Pieces">The counterparts, with the corrections of the program that cut the last one.</param>
/// <param name="Next">What they say about the next one; null for a single counterpart, of which only its measurement is known.</param>
public sealed record CounterpartLot(MeasuredLot Pieces, Lot? Next)
{
    /// <summary>Adds a measured counterpart to those before it.</summary>
    /// <param name="job">The job.</param>
    /// <param name="maps">The mapped features, for the normals.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="measured">The counterpart, aligned.</param>
    /// <param name="previous">The match whose program cut it; null if no match before it is known.</param>
    /// <param name="latest">The last match, if other counterparts were measured between these two; otherwise null.</param>
    /// <param name="toolChanged">True if the tool was changed before it.</param>
    internal static Outcome<CounterpartLot> Add(
        MatingJob job,
        IReadOnlyList<FeatureMap> maps,
        MeasurementFile theoretical,
        AlignedMeasurement measured,
        PreviousMatch? previous,
        PreviousMatch? latest,
        bool toolChanged)
    {
        double[] errors = [
            .. maps.SelectMany(map => map.Feature.Points.Select((label, i) => map.Normals[i].Dot(
                measured.Points[label] - ProjectedPoint.Of(theoretical[label], map.Feature.Plane, theoretical.File).Position)))];
        var cutBy = previous?.Pieces ?? new(job.KeyPoints, [], new double[errors.Length]);

        // All pieces that are known, and what the program of this one corrects.
        var pieces = (latest?.Pieces ?? cutBy) with { CorrectionsMm = cutBy.CorrectionsMm };
        if (pieces.Refuse(job.KeyPoints, measured.File.Sha256) is { } refusal)
        {
            return refusal;
        }

        var values = new LotPiece(errors, pieces.CorrectionsMm) { IsAfterToolChange = toolChanged };
        var u = job.Gauge.Uncertainty.CombinedMm;
        var all = pieces.With(pieces.Pieces.Count == 0
            ? new(measured.File.Sha256, u, values)
            : RecordedPiece.After(pieces.Pieces[^1], measured.File.Sha256, values));

        // As many counterparts as were measured since the program of this one was made will be cut before the next program is there.
        var known = cutBy.Pieces.Select(p => p.MeasuredSha256).ToHashSet(StringComparer.Ordinal);
        var ahead = pieces.Pieces.Count(p => !known.Contains(p.MeasuredSha256));
        return new CounterpartLot(all, all.Pieces.Count == 1 ? null : all.Estimate(u, ahead));
    }

    /// <summary>How far from its design the counterpart that this program cuts next is expected along the normal of a key point, mm; null
    /// for a single counterpart.</summary>
    /// <param name="point">Number of the key point in the order of the job.</param>
    internal double? ExpectedMm(int point) => Next is { } next ? next.ExpectedMm[point] + Pieces.CorrectionsMm[point] : null;

    // An error of a fifth of what is uncertain anyway costs 2 % more.
    private const double Worth = 0.2;

    /// <summary>How far off the next counterpart must be expected to be for a correction, mm: correcting less gains next to nothing. Null
    /// for a single counterpart, which is judged by the noise of its measurement.</summary>
    internal double? WorthMm => Next is { } next ? Worth * Math.Sqrt(next.UncertaintyMm.Average(e => e * e)) : null;

    /// <summary>Standard uncertainty of the deviations that a decision is based on: that of the part's points and of the expected
    /// counterpart.</summary>
    internal double UncertaintyMm(MatingJob job)
    {
        var u = job.Gauge.Uncertainty.CombinedMm;
        return Next is { } next ? Math.Sqrt((u * u) + next.UncertaintyMm.Average(e => e * e)) : job.DeviationUncertaintyMm;
    }

    /// <summary>The lot as the next match needs it.</summary>
    /// <param name="movedMm">How far the new program moves each key point along its normal from the program that cut the last
    /// counterpart.</param>
    internal CounterpartLot After(IEnumerable<double> movedMm) =>
        this with { Pieces = Pieces with { CorrectionsMm = [.. Pieces.CorrectionsMm.Zip(movedMm, (was, by) => was + by)] } };
}
