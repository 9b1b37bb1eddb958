using System.Globalization;
using System.Text.Json;
using ErrorMatching.Freeform;

namespace ErrorMatching.Console;

/// <summary>A finishing program that follows the compensation.</summary>
/// <param name="job">The job.</param>
/// <param name="program">The program as the user named it.</param>
/// <param name="displaced">What became of it.</param>
/// <param name="compensation">What it follows.</param>
/// <param name="folder">The folder that it was written to; null if nothing was written.</param>
internal sealed class SurfaceDisplaceAnswer(FreeformJob job, string program, DisplacedProgram displaced, CompensationResult compensation, string? folder) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/surface-displace/1";

    /// <summary>Where the program goes.</summary>
    public string File => Path.Combine(folder ?? "", Path.GetFileName(program));

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("job", job.Name);
        json.WriteString("program", program);
        json.WriteString("file", folder is null ? null : File);
        json.WriteNumber("onSurface", displaced.OnSurface);
        json.WriteNumber("followed", displaced.Followed);
        json.WriteNumber("largestMoveMm", displaced.LargestMoveMm);
        json.WriteNumber("largestMisfitMm", displaced.LargestMisfitMm);
        json.WriteNumber("changedBlocks", displaced.Rewrite.ChangedBlocks.Count);
        json.WriteNumber("changedWords", displaced.Rewrite.ChangedWords);
        json.WriteStartObject("proof");
        json.WriteBoolean("holds", displaced.Proof.Holds);
        json.WriteNumber("motions", displaced.Proof.Motions);
        json.WriteNumber("movedMotions", displaced.Proof.MovedMotions);
        json.WriteNumber("maxDeviationFromWantedMm", displaced.Proof.MaxDeviationFromWantedMm);
        json.WriteBoolean("untouchedBytesIdentical", displaced.Proof.UntouchedBytesIdentical);
        json.WriteEndObject();
        Strings(json, "warnings", compensation.Warnings);
        Strings(json, "notes", compensation.Notes);
    }

    /// <inheritdoc/>
    public override void WriteText(Page page)
    {
        page.Heading(string.Create(
            CultureInfo.InvariantCulture,
            $"{job.Name}: {displaced.OnSurface} points of {program} follow the compensation, by at most {displaced.LargestMoveMm * 1000:0.00} um; {displaced.Followed} near by go along"));
        page.Line();
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Between two points a straight cut misses the compensation by at most {displaced.LargestMisfitMm * 1000:0.00} um."));
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Proof holds: of {displaced.Proof.Motions} motions {displaced.Proof.MovedMotions} moved, none further than {displaced.Proof.MaxDeviationFromWantedMm:0.0000} mm from where it was wanted; every byte besides is the original's."));
        foreach (var warning in compensation.Warnings)
        {
            page.Line("Warning: " + warning);
        }

        foreach (var note in compensation.Notes)
        {
            page.Line("Note: " + note);
        }

        page.Line();
        page.Line(folder is null ? "Nothing was written. Add --out DIR to write the program." : $"Wrote {File}. Next: cut with it, measure again, and compare by errormatch surface evaluate.");
    }

    private static void Strings(Utf8JsonWriter json, string name, IReadOnlyList<string> texts)
    {
        json.WriteStartArray(name);
        foreach (var text in texts)
        {
            json.WriteStringValue(text);
        }

        json.WriteEndArray();
    }
}
