using System.Globalization;
using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>Writes a tool path as a program for a control: modal words only where they change, coordinates to the control's least increment.</summary>
public static class FinishingProgram
{
    /// <summary>The file name of a stage's program: <c>finishing.nc</c>, <c>semi-finishing.nc</c> or <c>roughing.nc</c>.</summary>
    public static string FileOf(CuttingStage stage) => NameOf(stage) + ".nc";

    /// <summary>The program as bytes.</summary>
    /// <exception cref="ArgumentException">As of <see cref="Write(ToolPath, FreeformJob, NcDialect, CuttingStage, Stream, Marker?)"/>.</exception>
    /// <exception cref="FreeformException">As of the same.</exception>
    public static byte[] Write(ToolPath path, FreeformJob job, NcDialect dialect, CuttingStage stage = CuttingStage.Finishing, Marker? marker = null)
    {
        using var stream = new MemoryStream();
        Write(path, job, dialect, stage, stream, marker);
        return stream.ToArray();
    }

    /// <summary>Writes the program to a stream. Passes are made one after another as they are written, so memory stays that of one pass however long the program is.</summary>
    /// <param name="path">The path.</param>
    /// <param name="job">The job: name, tool, speed, feed, and what of the ball is programmed.</param>
    /// <param name="dialect">The control that the path was planned for.</param>
    /// <param name="stage">What the program says that it does.</param>
    /// <param name="stream">Where it goes; it stays open.</param>
    /// <param name="marker">The comment by which a compensated program tells what it was made of; null where it follows no measurement.</param>
    /// <exception cref="ArgumentException">The path was planned for a control with another least increment.</exception>
    /// <exception cref="FreeformException">Speed or feed of the job would be written as 0 (<c>rounds-to-zero</c>).</exception>
    public static void Write(ToolPath path, FreeformJob job, NcDialect dialect, CuttingStage stage, Stream stream, Marker? marker = null)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(dialect);
        ArgumentNullException.ThrowIfNull(stream);
        if (path.Decimals != dialect.MetricDecimals)
        {
            throw new ArgumentException($"The path was rounded to {path.Decimals} decimals, but {dialect.Name} writes {dialect.MetricDecimals}.", nameof(dialect));
        }

        var frame = ProgramFrame.Of(dialect);
        var values = Values(path, job, stage);
        var head = ProgramFrame.Fill(frame.Before, values);
        stream.Write(marker is null ? head : marker.InsertInto(NcProgram.Read(head, dialect.Syntax)));
        var tipBelow = job.Toolpath.ProgramsTip ? path.RadiusMm : 0;
        var writer = new MoveWriter(stream, path.Decimals, tipBelow, Encoding.ASCII.GetBytes("F" + Word(job, "feedMmPerMin", job.Tool.FeedMmPerMin, 3)), path.TravelCenterZ);
        foreach (var move in path.Moves())
        {
            writer.Write(move);
        }

        writer.Flush();
        stream.Write(ProgramFrame.Fill(frame.Behind, values));
    }

    private static Dictionary<string, string> Values(ToolPath path, FreeformJob job, CuttingStage stage) => new()
    {
        ["name"] = job.Name,
        ["stage"] = NameOf(stage),
        ["passes"] = path.Passes.ToString(CultureInfo.InvariantCulture),
        ["points"] = path.Points.ToString(CultureInfo.InvariantCulture),
        ["minutes"] = Number(path.LengthMm / job.Tool.FeedMmPerMin, 1),
        ["diameter"] = Number(2 * path.RadiusMm, 4),
        ["flutes"] = job.Tool.Flutes.ToString(CultureInfo.InvariantCulture),
        ["moves"] = job.Toolpath.ProgramsTip ? "tip" : "center",
        ["stock"] = Number(path.StockMm, 4),
        ["scallop"] = Number(path.Certificate.ScallopMm, 6),
        ["chord"] = Number(path.Certificate.ChordMm, 6),
        ["rpm"] = Word(job, "spindleRpm", job.Tool.SpindleRpm, 0),
        ["travel"] = (path.TravelCenterZ - (job.Toolpath.ProgramsTip ? path.RadiusMm : 0)).ToString("F" + path.Decimals.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture),
    };

    // A spindle that stands still, or a feed that never arrives, is nothing that a job can mean.
    private static string Word(FreeformJob job, string key, double value, int decimals) => Number(value, decimals) is var text and not "0" ? text : throw new FreeformException(
        "rounds-to-zero", job.File, string.Create(CultureInfo.InvariantCulture, $"{key} of {value} would be written as 0; at least {Math.Pow(10, -decimals)} is expected"));

    private static string Number(double value, int decimals) => Math.Round(value, decimals).ToString("0." + new string('#', decimals), CultureInfo.InvariantCulture);

    private static string NameOf(CuttingStage stage) => stage switch
    {
        CuttingStage.Roughing => "roughing",
        CuttingStage.SemiFinishing => "semi-finishing",
        _ => "finishing",
    };
}
