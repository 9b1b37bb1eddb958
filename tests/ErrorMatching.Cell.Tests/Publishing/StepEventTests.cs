using System.Collections.Concurrent;
using System.Text;
using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>What the plant hears of each step.</summary>
public sealed class StepEventTests
{
    [Fact]
    public async Task A_message_is_the_same_whenever_it_is_made()
    {
        await using var cell = new RunningCell("""{ "approve": "person" }""");
        var early = new ConcurrentDictionary<string, string>(StringComparer.Ordinal);
        cell.AroundStep = (_, isDone) =>
        {
            if (isDone)
            {
                Keep();
            }
        };
        cell.Start();
        cell.Drop("a_1.csv", 1);
        await cell.Until(1, CorrectionState.Proposed);
        cell.DropText("a_2.csv", "no table");
        await cell.Until(2, CorrectionState.Refused);
        var decisions = new CorrectionDecisions(cell.Store);
        Keep();
        decisions.Approve(1, "sam", null);
        Keep();
        await cell.Until(1, CorrectionState.Verified);
        Keep();
        var again = Messages(cell);

        Assert.Equal(
            ["archived", "recognized", "computed", "proposed", "archived", "recognized", "refused", "approved", "uploading", "verified"],
            again.Select(m => m.GetProperty("to").GetString()));
        Assert.Equal(
            [null, "archived", "recognized", "computed", null, "archived", "recognized", "proposed", "approved", "uploading"],
            again.Select(m => m.TryGetProperty("from", out var from) ? from.GetString() : null));
        Assert.All(again, m => Assert.Equal(early[m.GetProperty("id").GetString()!], m.GetRawText()));
        Assert.Equal(
            cell.Store.AuditEntries(0, 1000).Where(e => CorrectionRow.StateOrNull(e.What) is not null).Select(e => e.Hash),
            again.Select(m => m.GetProperty("id").GetString()));
        Assert.Equal("person", again[7].GetProperty("by").GetString());
        Assert.DoesNotContain("sam", string.Concat(again.Select(m => m.GetRawText())), StringComparison.Ordinal);
        Assert.Equal(cell.Store.Find(2)!.Code, again[6].GetProperty("code").GetString());
        Assert.Equal(cell.Store.Find(1)!.ProgramSha256, again[9].GetProperty("programSha256").GetString());

        void Keep()
        {
            foreach (var message in Messages(cell))
            {
                early.TryAdd(message.GetProperty("id").GetString()!, message.GetRawText());
            }
        }
    }

    [Fact]
    public async Task The_page_shows_every_member_of_a_message()
    {
        await using var cell = new RunningCell("""{ "approve": "automatic" }""");
        cell.Start();
        cell.Drop("b_17_WO4711.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        cell.DropText("x.csv", "no job has this name");
        await cell.Until(2, CorrectionState.Refused);
        var page = File.ReadAllText(Repository.PathTo("docs", "events.md"));
        var begin = page.IndexOf("```json\n{", StringComparison.Ordinal) + "```json\n".Length;
        using var shown = JsonDocument.Parse(page[begin..page.IndexOf("```", begin, StringComparison.Ordinal)]);

        var names = Messages(cell).SelectMany(m => m.EnumerateObject()).Select(p => p.Name).ToHashSet(StringComparer.Ordinal);
        var verified = Messages(cell).Single(m => m.GetProperty("to").ValueEquals("verified"));

        Assert.Equal(verified.EnumerateObject().Select(p => p.Name), shown.RootElement.EnumerateObject().Select(p => p.Name));
        Assert.Equal(StepEvent.Schema, shown.RootElement.GetProperty("schema").GetString());
        Assert.All(names, name => Assert.Contains($"`{name}`", page, StringComparison.Ordinal));
    }

    [Fact]
    public async Task The_cursor_begins_at_the_end_of_the_trail_and_goes_only_forward()
    {
        await using var cell = new RunningCell();
        var cursor = new EventCursor(cell.Store, "Cell 1");
        Assert.Equal(0, cursor.Read());
        cursor.Begin();
        Assert.Equal(cell.Store.AuditHead().Seq, cursor.Read());
        cell.Store.Audit("cell", "started", "", "Cell 1");
        cursor.Begin();
        Assert.Equal(cell.Store.AuditHead().Seq - 1, cursor.Read());
        cursor.Advance(100);
        cursor.Advance(99);
        Assert.Equal(100, cursor.Read());
        Assert.Equal(0, new EventCursor(cell.Store, "Cell 2").Read());
    }

    private static IReadOnlyList<JsonElement> Messages(RunningCell cell)
    {
        var (steps, last) = new StepFeed(cell.Store, cell.Settings).After(0, 1000);
        Assert.True(last >= steps.Count);
        return [.. steps.Select(s => JsonDocument.Parse(Encoding.UTF8.GetString(s.Message("Cell 1"))).RootElement)];
    }
}
