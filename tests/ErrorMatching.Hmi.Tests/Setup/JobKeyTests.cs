using System.Text.RegularExpressions;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Each key of a job has a field at the station, or is known to have none.</summary>
public sealed class JobKeyTests
{
    // Set in the job's file only. What is chosen on the screen in another way than in a field is among them: files, program, control.
    private static readonly string[] WithoutField = [
        "$.$schema", "$.kind", "$.part.measured", "$.gauge.labels", "$.gauge.uncertaintyMm.shared", "$.without", "$.commonMotionMm",
        "$.features.kind", "$.features.toleranceFrom", "$.features.gapMm", "$.features.base", "$.features.formMm",
        "$.counterpart.blockSkip", "$.counterpart.assume", "$.counterpart.programSha256", "$.counterpart.libraries", "$.correction.allow",
        "$.correction.otherCuts", "$.correction.withinMm", "$.correction.firstVariable", "$.correction.programNumber", "$.correction.tool",
        "$.correction.radiusOffset", "$.correction.stepMm", "$.correction.totalMm", "$.correction.stepDegrees",
        "$.correction.totalDegrees"];

    [Fact]
    public Task Each_key_of_the_schema_has_a_field_or_is_known_to_have_none() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var fields = new HashSet<string>(StringComparer.Ordinal);
        var draft = seat.Draft.With("$.toleranceChain[0].name", "a")
            .With("$.decision.rule", "guard-band")
            .With("$.verify[0].quantity", "angle")
            .With("$.verify[1].quantity", "deviation");
        draft = FeatureKinds.All.Aggregate(
            draft, (d, k) => d with { Features = [.. d.Features, FeatureDraft.New(k, k.Word, d)] });
        foreach (var one in new[]
        {
            draft.With("$.alignment.kind", "datum"),
            draft.With("$.alignment.kind", "best-fit").With("$.gauge.uncertaintyMm[0].name", "a"),
        })
        {
            seat.Shell.Editing.Change("", _ => one);
            seat.Settle();
            using var points = new PointsViewModel(seat.Shell);
            fields.UnionWith(seat.System.Fields.Concat(points.Fields).Select(f => KeyOf(f.Path)));
        }

        // The three switches are of one key; coordinates are of no key but in the points' own file.
        Assert.Equal(3, fields.RemoveWhere(f => f.StartsWith("$.alignment.lock", StringComparison.Ordinal)));
        fields.Add("$.alignment.locked");
        fields.RemoveWhere(f => f.Contains('/', StringComparison.Ordinal));
        fields.Remove("$.features");
        fields.Remove("$.otherPoints");
        fields.Remove("$.recognition");
        var keys = KeysOf(MatingJob.Schema.Root, "$").Where(k => !k.StartsWith("$.recognition", StringComparison.Ordinal));
        Assert.Equal(
            keys.Distinct().Order(StringComparer.Ordinal), fields.Concat(WithoutField).Order(StringComparer.Ordinal));
    });

    // An item of a list has the keys of the list.
    private static string KeyOf(string path) => Regex.Replace(path, @"\[[0-9]+\]", "", RegexOptions.None, TimeSpan.FromSeconds(1));

    // Keys of values, not of the objects around them.
    private static IEnumerable<string> KeysOf(SchemaPlace place, string path)
    {
        var inside = place.Keys.SelectMany(k => KeysOf(place.Member(k), $"{path}.{k}"))
            .Concat(place.TakesLists ? KeysOf(place.Item, path).Where(k => k != path) : [])
            .ToArray();
        return inside.Length == 0 || place.TakesNumbers ? inside.Append(path) : inside;
    }
}
