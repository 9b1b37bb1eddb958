using ErrorMatching.Freeform;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>The report of the compensation before: what its program corrected, and the pieces that it knew.</summary>
/// <param name="File">The report.</param>
/// <param name="Lot">The lot.</param>
public sealed record PreviousReport(string File, MeasuredLot Lot)
{
    /// <summary>Its role in the new report.</summary>
    public const string Role = "previous";

    /// <summary>The size up to which a report is read.</summary>
    internal const long MaxBytes = 64L << 20;

    /// <summary>Reads it.</summary>
    /// <param name="files">The job's files.</param>
    /// <param name="given">The report; null for none.</param>
    /// <exception cref="InputException">It cannot be opened, it is no report of a compensation with a lot, or it is of another
    /// surface.</exception>
    public static PreviousReport? Read(FreeformFiles files, GivenFile? given)
    {
        if (given is null)
        {
            return null;
        }

        var report = ReportReader.Document(files.Bytes(Role, given, MaxBytes).Span, given.File);
        if (report.OptionalText("schema") is not (CompensationDocument.Schema or DisplacementDocument.Schema))
        {
            throw report.Refusal("schema", "not-a-compensation", "the report.json of errormatch surface compensate or surface displace");
        }

        ThrowIfWithheld(report);
        if (LotJson.Read(report).Pieces is not { } lot)
        {
            throw report.Refusal("lot", "lot-missing", "a report of this version, which says what its program corrected at each point");
        }

        var surface = files.Inputs.Last(i => i.Role == FreeformFiles.SurfaceRole).Sha256;
        if (report.Inputs().FirstOrDefault(i => i.Role == FreeformFiles.SurfaceRole) is not { } before || before.Sha256 != surface)
        {
            throw report.Refusal("inputs", "other-surface", "a report of the surface of this job; pieces of one lot have one surface");
        }

        return new(given.File, lot);
    }

    /// <summary>Refuses a report whose program was never written: no piece was cut by it.</summary>
    /// <exception cref="InputException">It is one.</exception>
    internal static void ThrowIfWithheld(ReportReader report)
    {
        if (Acceptance.Read(report) is { Withheld: { } verdict })
        {
            throw report.Refusal(
                "withheld",
                "previous-withheld",
                $"the report of a program that was written; of this one none was, because its verdict was {verdict}. Give the report "
                    + "before it");
        }
    }

    /// <summary>True if a program follows the measurement that this report compensated.</summary>
    public bool Made(string? measurementSha256) => measurementSha256 == Lot.Pieces[^1].MeasuredSha256;
}
