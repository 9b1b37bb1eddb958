using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The MQTT broker that every step of the cell is published to.</summary>
/// <param name="Host">Name or address.</param>
/// <param name="Port">Its port.</param>
/// <param name="Topic">The topic of all messages. One topic, because MQTT keeps the order of messages within a topic only.</param>
/// <param name="User">The login name; null for none.</param>
/// <param name="PasswordFile">A file with the password as its only line, which only its owner may read; null for none.</param>
/// <param name="IsEncrypted">True for TLS.</param>
/// <param name="AuthorityFile">Certificates of the authorities (PEM) of which one must have signed the broker's certificate; null if its
/// key is pinned.</param>
/// <param name="PinnedKey">The broker's public key as <c>sha256//</c> and base64; null if an authority vouches for it.</param>
public sealed record EventSettings(
    string Host, int Port, string Topic, string? User, string? PasswordFile, bool IsEncrypted, string? AuthorityFile, string? PinnedKey)
{
    /// <summary>The topic of what waits. Its last message is kept by the broker.</summary>
    public string BacklogTopic => Topic + "/backlog";

    /// <summary>The broker as a URI without a password.</summary>
    public string Address => string.Create(
        CultureInfo.InvariantCulture, $"{(IsEncrypted ? "mqtts" : "mqtt")}://{(User is null ? "" : User + "@")}{Host}:{Port}");
}

/// <summary>Reads the settings of the broker.</summary>
internal static class EventReader
{
    private const int PlainPort = 1883;
    private const int TlsPort = 8883;

    public static EventSettings Read(JsonItem item, CellPaths paths, CellProblems problems)
    {
        var isEncrypted = item.Find("tls")?.Flag ?? true;
        var (authority, pin) = (item.Find("caFile"), item.Find("pinnedKey"));
        CheckTrust(item, isEncrypted, authority, pin, problems);
        if (item.Find("passwordFile") is { } secret && item.Find("user") is null)
        {
            problems.Refuse(secret, "user-missing", "a password without a user", "\"user\" beside it");
        }

        return new(
            item["host"].Text,
            (int)(item.Find("port")?.Number ?? (isEncrypted ? TlsPort : PlainPort)),
            item.Find("topic")?.Text ?? "errormatch/steps",
            item.Find("user")?.Text,
            item.Find("passwordFile") is { } file ? paths.Of(file) : null,
            isEncrypted,
            authority is null ? null : paths.Of(authority),
            pin?.Text);
    }

    private static void CheckTrust(JsonItem item, bool isEncrypted, JsonItem? authority, JsonItem? pin, CellProblems problems)
    {
        if (!isEncrypted)
        {
            if ((pin ?? authority) is { } trusted)
            {
                problems.Refuse(
                    trusted, "pin-without-tls", "a certificate for a connection that is not encrypted", "\"tls\": true, or no certificate");
            }

            problems.Warn(
                item["tls"],
                "plain-mqtt",
                "MQTT that is not encrypted",
                "true: anybody on this network can read the password and every message");
        }
        else if (authority is null && pin is null)
        {
            problems.Refuse(
                item,
                "pin-missing",
                "neither \"caFile\" nor \"pinnedKey\"",
                "one of them: without it no TLS connection is trusted; or \"tls\": false");
        }
        else if (authority is not null && pin is not null)
        {
            problems.Refuse(
                pin, "pin-beside-authority", "\"pinnedKey\" beside \"caFile\"", "one of them: only one can decide who the broker is");
        }
    }
}
