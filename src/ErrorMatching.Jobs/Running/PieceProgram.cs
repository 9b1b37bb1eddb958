using ErrorMatching.Freeform;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Checks the program that cut the measured piece. If it already followed a measurement, the piece only has the errors
/// that the correction left. A program that compensates these from the nominal surface would be nearly nominal and lose
/// it.</summary>
/// <param name="files">The job's files.</param>
/// <param name="request">The other inputs.</param>
/// <param name="syntax">The syntax of cutting programs.</param>
/// <param name="previous">The report whose program cut the piece; null if a nominal program did.</param>
internal sealed class PieceProgram(FreeformFiles files, SurfaceRequest request, NcSyntax syntax, PreviousReport? previous)
{
    /// <summary>Code of the refusal.</summary>
    public const string Code = "piece-compensated";

    private const string WhatToDo =
        "The error of such a piece is small because of that correction, and a program made of this measurement would give the correction "
            + "up. "
        + "Name the report of that program by --previous, and its correction goes on; or measure a piece that the nominal program "
            + "cut (errormatch surface toolpath, or the program of the CAM). "
        + "How good this piece is, errormatch surface evaluate says.";

    private const string OtherProgram = "previous-differs";

    private readonly List<string> _measurements = [];

    /// <summary>The program for the report; set if no refusal was found.</summary>
    public MeasuredPieceProgram Found { get; private set; } = new(null, null);

    /// <summary>Why the measured piece must not be compensated; null if there is no reason.</summary>
    /// <param name="measured">The measurements.</param>
    /// <param name="earlier">Those of earlier pieces that the same program cut.</param>
    /// <param name="made">The file to be written, which may contain a program of an earlier run; null if unknown.</param>
    /// <param name="baseSha256">Base hash in the markers of this job's programs.</param>
    /// <exception cref="InputException">A program cannot be opened.</exception>
    public Refusal? Refusal(
        IReadOnlyList<MeasuredPoints> measured, IReadOnlyList<MeasuredPoints> earlier, string? made, string baseSha256)
    {
        MeasuredPoints[] all = [.. earlier, .. measured];
        _measurements.AddRange(all.Select(m => m.Sha256));
        _measurements.Add(MeasuredPoints.Sha256Of(measured));
        if (Named() is { } refused)
        {
            return refused;
        }

        if (Continues)
        {
            return all.FirstOrDefault(m => m.CutByMeasurement is not null && !previous!.Made(m.CutByMeasurement)) is { } other
                ? new Refusal(OtherProgram, "the log says that a program cut the piece that " + NotOfPrevious).In(other.File)
                : null;
        }

        return all.FirstOrDefault(m => m.CutByMeasurement is not null) is { } log
            ? Refuse(log.File, "the log says that the piece was cut just before by a program that follows a measurement already.", null, 0)
            : Found.File is null && made is not null ? Beside(made, baseSha256) : null;
    }

    // A piece that still has its stock has not been cut by the program of the previous report.
    private bool Continues => previous is not null && files.Job.Stock.Of(files.Job.Measuring.After) == 0;

    private string NotOfPrevious => $"names another measurement than the last piece of {previous!.File}: that report's program did not cut "
        + "this piece. Name the report that belongs to the program.";

    private Refusal? Named()
    {
        if ((request.CutBy is { } given ? files.Given(FreeformFiles.CutByRole, given) : files.CutBy()) is not { Bytes: { } bytes } named)
        {
            return null;
        }

        var program = NcProgram.Read(bytes, syntax);
        Found = new(named.File, files.Inputs.Last(i => i.Role == FreeformFiles.CutByRole).Sha256);
        if (Continues)
        {
            return Marker.Find(program) switch
            {
                [] => new Refusal(
                    OtherProgram,
                    "the program that cut the measured piece carries no marker, so it corrected nothing: leave out the previous report, or "
                        + "name the program that its compensation wrote.").In(named.File),
                [var (marked, marker), ..] when !previous!.Made(marker?.MeasurementSha256) => BlockRefusal.At(
                    program, marked, OtherProgram, "the marker of the program that cut the measured piece " + NotOfPrevious).In(named.File),
                _ => null,
            };
        }

        return Marker.Find(program) is [var (block, _), ..]
            ? Refuse(
                named.File,
                "the program that cut the measured piece carries a marker, so it follows a measurement already.",
                program,
                block)
            : null;
    }

    // A finishing program cut a piece without stock; the last one is where this run will write. A repeated measurement is not a new piece.
    private Refusal? Beside(string made, string baseSha256)
    {
        if (files.Job.Stock.Of(files.Job.Measuring.After) > 0 || !File.Exists(made))
        {
            return null;
        }

        var program = NcProgram.Read(InputFile.Program(made), syntax);
        var others = Marker.Find(program).Where(m => m.Marker is null
            || (m.Marker.BaseSha256 == baseSha256 && !_measurements.Contains(m.Marker.MeasurementSha256, StringComparer.Ordinal)));
        return others.ToArray() is not [var other, ..] ? null : Refuse(
            made,
            "the program here follows another measurement of this surface. If it cut the measured piece:",
            program,
            other.Block,
            " If another one did, name that by --cut-by, or as \"cutBy\" under \"measuring\".");
    }

    private static Refusal Refuse(string file, string found, NcProgram? program, int block, string more = "")
    {
        var message = $"{found} {WhatToDo}{more}";
        return (program is null ? new(Code, message) : BlockRefusal.At(program, block, Code, message)).In(file);
    }
}
