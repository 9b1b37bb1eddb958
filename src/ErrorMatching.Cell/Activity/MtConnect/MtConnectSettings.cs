using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>An MTConnect agent.</summary>
/// <param name="Url">Its base address.</param>
/// <param name="Device">Name or UUID of the device; null if the agent has only one.</param>
/// <param name="StoppedIsIdle">True if the execution STOPPED means that nothing is active.</param>
internal sealed record MtConnectSettings(Uri Url, string? Device, bool StoppedIsIdle) : StateSettings
{
    /// <inheritdoc/>
    public override string Address => Url.AbsoluteUri;

    public static MtConnectSettings Read(JsonItem item, CellProblems problems)
    {
        var text = item["url"].Text;
        if (!Uri.TryCreate(text, UriKind.Absolute, out var url)
            || url.UserInfo.Length > 0 || url.Query.Length > 0 || url.Fragment.Length > 0)
        {
            problems.Refuse(item["url"], "bad-agent-url", $"the address \"{Hidden(text)}\"",
                "http:// or https://, a host, a port if it is not the usual one, and a path if there is one; no password");
            url = new("http://localhost");
        }

        return new(url, item.Find("device")?.Text, item.Find("stopped")?.Text == "idle");
    }

    internal override MachineStateSource Open(TimeProvider clock) => new MtConnectAgent(this);

    // A password that somebody wrote into an address is not repeated.
    private static string Hidden(string text) => text.LastIndexOf('@') is >= 0 and var at ? "...@" + text[(at + 1)..] : text;
}
