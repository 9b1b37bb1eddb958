using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>The MQTT broker that hears of every step of the cell.</summary>
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
