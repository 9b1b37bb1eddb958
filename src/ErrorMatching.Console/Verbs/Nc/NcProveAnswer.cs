using System.Globalization;
using System.Text.Json;
using ErrorMatching.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>A successful proof, and what moved by how much.</summary>
/// <param name="before">The original.</param>
/// <param name="after">The result.</param>
/// <param name="file">The wish file.</param>
/// <param name="wish">Its content.</param>
/// <param name="proof">The result of the proof.</param>
/// <param name="comparison">Both programs, motion by motion.</param>
internal sealed class NcProveAnswer(string before, string after, string file, WishFile wish, NcProof proof, MotionComparison comparison)
    : DocumentAnswer
{
    private const int MotionsShown = 20;

    public override string Schema => "errormatch/nc-prove/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("before", before);
        json.WriteString("beforeSha256", wish.BeforeSha256);
        json.WriteString("after", after);
        json.WriteString("afterSha256", ContentHash.Sha256(comparison.After.Program.Bytes.Span));
        json.WriteString("wish", file);
        json.WriteString("dialect", wish.Dialect);
        json.WriteNumber("leastIncrementMm", wish.LeastIncrementMm);
        json.WriteNumber("wishedMotions", Math.Max(wish.Wish.Elements.Count, wish.Wish.EndPoints.Count));
        json.WriteStartArray("motions");
        foreach (var difference in comparison.Differences)
        {
            var was = new ShownMotion(comparison.Before, difference.Before);
            json.WriteStartObject();
            json.WriteString("block", was.Block);
            json.WriteNumber("line", was.Line);
            ShownDifference.WriteVector(json, "displacement", difference.Displacement);
            ShownDifference.WriteVector(json, "centerDisplacement", ShownDifference.Center(comparison, difference));
            json.WriteEndObject();
        }

        json.WriteEndArray();
        ShownProof.Write(json, proof);
    }

    public override void WriteText(Page page)
    {
        page.Heading(string.Create(CultureInfo.InvariantCulture, $"{after} is {before} as {file} asks"));
        page.Line();
        if (comparison.Differences.Count > 0)
        {
            page.Table(["line", "block", "dx", "dy", "dz", "center dx", "dy", "dz"], comparison.Differences.Take(MotionsShown).Select(Row));
            if (comparison.Differences.Count > MotionsShown)
            {
                page.Line(string.Create(
                    CultureInfo.InvariantCulture,
                    $"... and {comparison.Differences.Count - MotionsShown} more motions; --json lists them all."));
            }

            page.Line();
        }

        ShownProof.Write(page, proof);
    }

    private IReadOnlyList<string> Row(MotionDifference difference)
    {
        var was = new ShownMotion(comparison.Before, difference.Before);
        return [
            was.Line.ToString(CultureInfo.InvariantCulture),
            was.Block,
            .. ShownDifference.Cells(difference.Displacement),
            .. ShownDifference.Cells(ShownDifference.Center(comparison, difference))];
    }
}
