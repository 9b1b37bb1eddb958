using ErrorMatching.Json;
using ErrorMatching.Refusals;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Cell.Tests;

public sealed class MutatedConfigurationTests
{
    private static readonly string[] Pieces =
        [
            "", "\"", "{", "}", "[", "]", ",", ":", "null", "true", "-1", "1e400", "0.5", "\"\"", "\"..\"", "\"\\u0000\"", "\"\\ud800\"",
            "*", "?", "/", "\\\\", "(", ")", "\"name\"", "\"rename\"", "{}", "[]", "\"cmm\"", "\n", "//", "/*", "\uFEFF", "é"];

    private static readonly Gen<(double From, double Length, string Text)[]> Mutations =
        (
            from at in Gen.Choose(0, 9_999)
            from length in Gen.Elements(0, 1, 1, 2, 5, 20)
            from piece in Gen.Elements(Pieces)
            select (at / 10_000.0, (double)length, piece)).NonEmptyListOf()
                .Select(l => l.Take(4).ToArray());

    [Fact]
    public void A_changed_configuration_is_read_or_refused_by_path_and_never_anything_else()
    {
        using var cell = new CellFolder();
        var (read, refused) = (0, 0);
        Prop.ForAll(Mutations.ToArbitrary(), mutations =>
        {
            var text = mutations.Aggregate(CellFolder.Right, Apply);
            try
            {
                Assert.NotEmpty(cell.Read(text).Gauges);
                read++;
            }
            catch (InputException e)
            {
                Assert.NotEmpty(e.Refusals);
                Assert.All(e.Refusals, p => Assert.True(
                    p.Place is { Line: >= 1, Column: >= 1, Path: ['$', ..] } && p.Message.Length > 0));
                refused++;
            }
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(1000).WithReplay(2026, 11));
        Assert.True(read > 0 && refused > 300, $"{read} read, {refused} refused");
    }

    [Fact]
    public void Each_value_may_be_of_any_kind_without_another_error()
    {
        using var cell = new CellFolder();
        foreach (var path in Values(JsonInput.Read(System.Text.Encoding.UTF8.GetBytes(CellFolder.Right), "cell.json")))
        {
            foreach (var other in new[]
            {
                "null",
                "true",
                "-1",
                "0",
                "\"x\"",
                "[]",
                "{}",
                "[\"x\"]",
                "\"con\"",
                "\"incoming\"",
                "\"jobs/mating.json\"",
                "1e9"
            })
            {
                var text = Replaced(JsonInput.Read(System.Text.Encoding.UTF8.GetBytes(CellFolder.Right), "cell.json"), path, other);
                try
                {
                    _ = cell.Read(text);
                }
                catch (InputException e)
                {
                    Assert.NotEmpty(e.Refusals);
                }
            }
        }
    }

    private static string Apply(string text, (double From, double Length, string Text) mutation)
    {
        var from = (int)(mutation.From * text.Length);
        return text[..from] + mutation.Text + text[Math.Min(text.Length, from + (int)mutation.Length)..];
    }

    private static IEnumerable<string> Values(JsonItem item) =>
        item.Items.Concat(item.Members.Select(m => m.Value)).SelectMany(Values).Prepend(item.Path);

    private static string Replaced(JsonItem item, string path, string other) => item.Path == path ? other : item.Kind switch
    {
        JsonItemKind.Object => "{" + string.Join(",", item.Members.Select(m => $"\"{m.Name}\":{Replaced(m.Value, path, other)}")) + "}",
        JsonItemKind.List => "[" + string.Join(",", item.Items.Select(i => Replaced(i, path, other))) + "]",
        _ => item.ToJson(),
    };
}
