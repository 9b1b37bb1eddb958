using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The pieces of a process that were measured one after the other, and how far the program for the next one moves the measured
/// points. A report carries it, so that the next correction can go on from it.</summary>
/// <param name="Points">The measured points, by their names.</param>
/// <param name="Pieces">The pieces in the order of cutting, each with the values at these points; at most <see cref="MostPieces"/>.</param>
/// <param name="CorrectionsMm">How far the program for the next piece moves each point along its normal, mm; positive leaves
/// material.</param>
public sealed record MeasuredLot(IReadOnlyList<string> Points, IReadOnlyList<RecordedPiece> Pieces, IReadOnlyList<double> CorrectionsMm)
{
    /// <summary>The number of pieces that are kept; older ones say little about the next.</summary>
    public const int MostPieces = 100;

    // A nanometer: what no probe tells.
    private const double LeastUncertaintyMm = 1e-6;

    /// <summary>Why a further piece cannot be added; null if it can.</summary>
    /// <param name="points">Its measured points.</param>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    public Refusal? Refuse(IReadOnlyList<string> points, string sha256)
    {
        ArgumentNullException.ThrowIfNull(points);
        if (Pieces.Select(p => p.MeasuredSha256).Contains(sha256, StringComparer.Ordinal))
        {
            return new(
                "same-measurement",
                "This measurement is in the lot of the previous report already: a piece counts once. Give the measurement of the piece "
                    + "that the previous report's program cut.");
        }

        if (points.SequenceEqual(Points))
        {
            return null;
        }

        var differ = Points.Except(points).FirstOrDefault() is { } lacking ? $"point {lacking} is missing now"
            : points.Except(Points).FirstOrDefault() is { } further ? $"point {further} is new"
            : "their order differs";
        return new(
            "other-points",
            string.Create(
                CultureInfo.InvariantCulture,
                $"The previous report has {Points.Count} measured points and this measurement {points.Count}; {differ}. Pieces of a lot "
                    + $"are measured at the same points: measure by the plan of the previous piece, or begin a new lot without "
                    + $"the previous report."));
    }

    /// <summary>The lot with a further piece, before it is known what the next program corrects.</summary>
    /// <param name="piece">The piece, with values at the points of the lot.</param>
    public MeasuredLot With(RecordedPiece piece)
    {
        ArgumentNullException.ThrowIfNull(piece);
        return this with { Pieces = [.. Pieces.Append(piece).TakeLast(MostPieces)] };
    }

    /// <summary>What the pieces say about the next one.</summary>
    /// <param name="uncertaintyMm">Stated standard uncertainty of one measured point; the noise that the pieces show counts if it is
    /// larger.</param>
    /// <param name="ahead">Number of pieces that are cut before it, and not measured yet.</param>
    public Lot Estimate(double uncertaintyMm, int ahead = 0)
    {
        // The median: a single piece that is off must not pass for noise.
        var noise = Pieces.Select(p => p.NoiseMm).Order().ElementAt((Pieces.Count - 1) / 2);
        return Lot.Estimate([.. Pieces.Select(p => p.Values)], Math.Max(Math.Max(uncertaintyMm, noise), LeastUncertaintyMm), ahead);
    }
}
