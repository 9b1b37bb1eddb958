using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Reads the settings of the broker that hears of the steps.</summary>
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
