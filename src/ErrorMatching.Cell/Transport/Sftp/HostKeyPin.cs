using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>The only key by which a server is trusted.</summary>
internal sealed class HostKeyPin
{
    private readonly byte[] _key;

    /// <summary>Reads a pinned key.</summary>
    /// <param name="pinned">The key as in <c>known_hosts</c>, such as <c>ssh-ed25519 AAAA...</c>.</param>
    public HostKeyPin(string pinned)
    {
        var space = pinned.IndexOf(' ', StringComparison.Ordinal);
        Kind = pinned[..Math.Max(space, 0)];
        _key = new byte[pinned.Length];
        _key = Convert.TryFromBase64String(pinned[(space + 1)..], _key, out var count) ? _key[..count] : [];
    }

    /// <summary>The key's type.</summary>
    public string Kind { get; }

    /// <summary>The signatures that a key of this type gives (RFC 8332, RFC 8709, RFC 5656), the best one first; none for a type that no
    /// server is trusted by, such as DSA. An RSA key must not sign with SHA-1.</summary>
    public IReadOnlyList<string> Signatures => Kind switch
    {
        "ssh-ed25519" or "ecdsa-sha2-nistp256" or "ecdsa-sha2-nistp384" or "ecdsa-sha2-nistp521" => [Kind],
        "ssh-rsa" => ["rsa-sha2-512", "rsa-sha2-256"],
        _ => [],
    };

    /// <summary>The fingerprint as OpenSSH prints it.</summary>
    public string Fingerprint => Of(_key);

    /// <summary>True if the server's key is this one.</summary>
    public bool IsKey(ReadOnlySpan<byte> offered) => _key.Length > 0 && offered.SequenceEqual(_key);

    /// <summary>Type and fingerprint of a server's key.</summary>
    public static string Describe(ReadOnlySpan<byte> key)
    {
        var kind = "unknown";
        if (key.Length > 4 && key[0] == 0 && key[1] == 0 && key[2] == 0 && key[3] < key.Length - 4)
            kind = ServerWords.Of(Encoding.ASCII.GetString(key.Slice(4, key[3])));
        return $"{kind} {Of(key)}";
    }

    private static string Of(ReadOnlySpan<byte> key) => "SHA256:" + Convert.ToBase64String(SHA256.HashData(key)).TrimEnd('=');
}
