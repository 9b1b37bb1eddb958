using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>An evaluated piece as a result for other systems (<see cref="QifWriter"/>, <see cref="AqdefWriter"/>).</summary>
public static class EvaluatedResult
{
    /// <summary>The measured points of a piece: wanted are the points of the surface with the stock of the stage, the deviation is the
    /// error along the normal. Its limits are those of the profile tolerance, unless that tolerance demands an alignment that the points
    /// do not have.</summary>
    /// <param name="job">The job as named in reports.</param>
    /// <param name="stock">The job's stock.</param>
    /// <param name="tolerance">The profile tolerance; null if the job has none.</param>
    /// <param name="piece">The piece.</param>
    public static PieceResult Of(ReportJob job, JobStock stock, ProfileTolerance? tolerance, EvaluatedPiece piece)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(stock);
        ArgumentNullException.ThrowIfNull(piece);
        var left = stock.Of(piece.Stage);
        var limits = tolerance is { } profile && profile.IsAligned == piece.Alignment is not null ? profile.Limits : null;
        return new(
            job.Name,
            piece.Sha256,
            [
                .. piece.Samples.Select(s => new PointResult(
                    s.Point.ToString(CultureInfo.InvariantCulture),
                    s.Nominal + (s.Normal * left),
                    s.Nominal + (s.Normal * (left + s.ErrorMm)),
                    s.Normal,
                    s.ErrorMm)
                {
                    Limits = limits is { } band ? (band.LowerMm, band.UpperMm) : null,
                }),
            ])
        {
            WorkOrder = job.WorkOrder,
        };
    }
}
