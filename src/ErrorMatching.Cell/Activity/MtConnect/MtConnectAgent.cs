using System.Net;
using System.Net.Http.Headers;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Asks an MTConnect agent by its <c>current</c> request (MTConnect Part 1). No redirect is followed, no proxy is used, and an
/// answer from a cache is none.</summary>
internal sealed class MtConnectAgent(MtConnectSettings settings) : MachineStateSource(settings.Address, settings.Timeout)
{
    private const int MostBytes = 4 << 20;

    // One connection for all questions of all agents; idle ones are closed.
    private static readonly HttpClient Client = new(new SocketsHttpHandler
    {
        AllowAutoRedirect = false,
        UseProxy = false,
        UseCookies = false,
        AutomaticDecompression = DecompressionMethods.None,
        MaxResponseHeadersLength = 16,
        MaxConnectionsPerServer = 4,
        PooledConnectionLifetime = TimeSpan.FromMinutes(2),
    })
    {
        Timeout = Timeout.InfiniteTimeSpan,
    };

    private readonly Uri _current = new(
        settings.Url.AbsoluteUri.TrimEnd('/') + (settings.Device is { } d ? "/" + Uri.EscapeDataString(d) : "") + "/current");

    protected override async Task<MachineState> AnswerAsync(CancellationToken cancellation)
    {
        using var request = new HttpRequestMessage(HttpMethod.Get, _current);
        request.Headers.CacheControl = new CacheControlHeaderValue { NoCache = true, NoStore = true };
        request.Headers.Accept.ParseAdd("text/xml");
        request.Headers.Accept.ParseAdd("application/xml");
        using var answer = await Client.SendAsync(request, HttpCompletionOption.ResponseHeadersRead, cancellation).ConfigureAwait(false);
        if ((int)answer.StatusCode is >= 300 and < 400)
            throw Wrong($"HTTP {(int)answer.StatusCode}: it sends the cell elsewhere, which the cell does not follow");
        if (!answer.IsSuccessStatusCode)
            throw Wrong($"HTTP {(int)answer.StatusCode}");
        if (answer.Headers.Age is { } age && age > TimeSpan.Zero)
            throw new StateException(StateCodes.Stale, Recorded.StateStale.With(Place, age.TotalSeconds, 0));
        var document = await ReadAsync(answer.Content, cancellation).ConfigureAwait(false);
        return new MtConnectStreams(settings, Place, Wrong).Read(document, cancellation);
    }

    private async Task<ReadOnlyMemory<byte>> ReadAsync(HttpContent content, CancellationToken cancellation)
    {
        using var document = new MemoryStream();
        var stream = await content.ReadAsStreamAsync(cancellation).ConfigureAwait(false);
        var buffer = new byte[16 << 10];
        for (int read; (read = await stream.ReadAsync(buffer, cancellation).ConfigureAwait(false)) > 0;)
        {
            if (document.Length + read > MostBytes)
                throw Wrong($"more than {MostBytes} bytes");
            document.Write(buffer, 0, read);
        }

        return document.GetBuffer().AsMemory(0, (int)document.Length);
    }
}

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
