using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The values of the placeholders of a <see cref="FinishingTemplate"/>.</summary>
internal sealed class FinishingValues(ToolPath path, FreeformJob job, CuttingStage stage, string template)
{
    /// <summary>Names of the placeholders, except those of the tool.</summary>
    public static readonly string[] OfProgram =
        [
            "name", "stage", "passes", "points", "minutes", "diameter", "flutes", "moves", "stock", "scallop", "chord", "rpm", "feed",
            "travel"];

    public string Feed { get; } = Word(job, "feedMmPerMin", job.Tool.FeedMmPerMin, 3);

    /// <summary>Fills the placeholders of lines.</summary>
    /// <exception cref="InputException">Speed or feed would be written as 0, or the tool has no such value.</exception>
    public byte[] Fill(IReadOnlyList<TemplateItem> items)
    {
        var text = new StringBuilder();
        TemplateText.Write(text, items, Holds, ValueOf, _ => throw new InvalidOperationException("There are no points."));
        return Encoding.UTF8.GetBytes(text.ToString());
    }

    private bool Holds(string condition) =>
        condition == TemplateGrammar.ToolByName ? job.Toolpath.Tool?.Name is not null : job.Toolpath.Tool is not null;

    private string ValueOf(string place) => place switch
    {
        "name" => Plain(job.Name),
        "stage" => FinishingProgram.NameOf(stage),
        "passes" => Count(path.Passes),
        "points" => Count(path.Points),
        "minutes" => Number(path.LengthMm / job.Tool.FeedMmPerMin, 1),
        "diameter" => Number(2 * path.RadiusMm, 4),
        "flutes" => Count(job.Tool.Flutes),
        "moves" => job.Toolpath.ProgramsTip ? "tip" : "center",
        "stock" => Number(path.StockMm, 4),
        "scallop" => Number(path.Certificate.ScallopMm, 6),
        "chord" => Number(path.Certificate.ChordMm, 6),
        "rpm" => Word(job, "spindleRpm", job.Tool.SpindleRpm, 0),
        "feed" => Feed,
        "travel" => (path.TravelCenterZ - (job.Toolpath.ProgramsTip ? path.RadiusMm : 0))
            .ToString("F" + Count(path.Decimals), CultureInfo.InvariantCulture),
        _ => job.Toolpath.Tool!.ValueOf(place, template),
    };

    // A job cannot intend a stopped spindle or a feed of 0.
    private static string Word(FreeformJob job, string key, double value, int decimals) => Number(value, decimals) is var text and not "0"
        ? text
        : throw InputException.At(
            "rounds-to-zero",
            job.File,
            string.Create(
                CultureInfo.InvariantCulture, $"{key} of {value} would be written as 0; at least {Math.Pow(10, -decimals)} is expected"));

    private static string Number(double value, int decimals) =>
        Math.Round(value, decimals).ToString("0." + new string('#', decimals), CultureInfo.InvariantCulture);

    private static string Count(int value) => value.ToString(CultureInfo.InvariantCulture);

    // Names are written into comments, so they must not contain anything that ends one.
    private static string Plain(string value) => string.Concat(value.Take(80).Select(c => c switch
    {
        '(' or '{' => '[',
        ')' or '}' => ']',
        >= ' ' and <= '~' and not '%' and not ';' => c,
        _ => '?',
    }));
}
