using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>Reads the report of the match whose program cut the measured counterpart.</summary>
internal static class PreviousMatchReport
{
    /// <summary>Code of the refusal of a report without a lot.</summary>
    public const string LotMissing = "lot-missing";

    /// <summary>Code of the refusal of a report with other key points.</summary>
    public const string OtherPoints = "other-points";

    /// <summary>Reads it.</summary>
    /// <param name="given">The report.</param>
    /// <param name="job">The job, which must have the same key points.</param>
    /// <param name="theoretical">The key points as designed, which must be the same.</param>
    /// <param name="program">The program that cut the counterpart, which the report must be about; null if it may be about another
    /// one.</param>
    /// <exception cref="InputException">It cannot be opened, it is no report of a match with a lot, or it does not belong to these
    /// inputs.</exception>
    public static PreviousMatch Read(GivenFile given, MatingJob job, MeasurementFile theoretical, NcProgram? program)
    {
        var bytes = given.Bytes ?? InputFile.Bytes(given.File, PreviousReport.MaxBytes);
        var report = ReportReader.Document(bytes.Span, given.File);
        if (report.OptionalText("schema") != MatchReportJson.Schema)
        {
            throw report.Refusal("schema", "not-a-match", "the report.json of errormatch match");
        }

        PreviousReport.ThrowIfWithheld(report);
        if (LotJson.Read(report).Pieces is not { } pieces)
        {
            throw report.Refusal("lot", LotMissing, "the report of a match in feedback by this version, which lists the counterparts");
        }

        if (report.Inputs().FirstOrDefault(i => i.Role == "theoretical")?.Sha256 != theoretical.Sha256
            || !pieces.Points.SequenceEqual(job.KeyPoints))
        {
            throw report.Refusal(
                "lot",
                OtherPoints,
                "a report with the key points of this job; all counterparts of a lot have the same, so begin a new lot without it");
        }

        return program is null || Made(report, pieces, program)
            ? new(given.File, ContentHash.Sha256(bytes.Span), pieces) { Offsets = MatchReportJson.OffsetsOf(report) }
            : throw report.Refusal("program", "other-program", "the report of the program that cut this counterpart");
    }

    // By its bytes, or by its marker if somebody has changed something else in it.
    private static bool Made(ReportReader report, MeasuredLot pieces, NcProgram program) =>
        report.Object("program").Text("sha256") == ContentHash.Sha256(program.Bytes.Span)
            || Marker.Find(program).Any(m => m.Marker?.MeasurementSha256 == pieces.Pieces[^1].MeasuredSha256);
}
