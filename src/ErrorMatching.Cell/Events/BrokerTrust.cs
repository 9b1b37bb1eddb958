using System.Net.Security;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;

namespace ErrorMatching.Cell;

/// <summary>Decides whether a broker's certificate is the trusted one: its key is pinned, or one of the configured authorities vouches for
/// the host's name. The computer's own list of authorities is not asked.</summary>
/// <param name="pinnedKey">The pinned key; null if authorities decide.</param>
/// <param name="authorities">The authorities; null if the key decides.</param>
internal sealed class BrokerTrust(string? pinnedKey, X509Certificate2Collection? authorities)
{
    private const string ServerAuthentication = "1.3.6.1.5.5.7.3.1";

    /// <summary>Why the certificate was not trusted; null if it was, or if none was seen.</summary>
    public string? Reason { get; private set; }

    /// <summary>True if the certificate is trusted.</summary>
    /// <param name="certificate">The broker's certificate; null if it has none.</param>
    /// <param name="sent">The certificates that the broker sent with it; null if none.</param>
    /// <param name="errors">What the platform found: of it, only the name of the host matters.</param>
    public bool Accepts(X509Certificate? certificate, X509Chain? sent, SslPolicyErrors errors)
    {
        Reason = certificate is null ? "the broker has no certificate"
            : pinnedKey is not null ? ReasonOfKey(certificate)
            : ReasonOfAuthority(certificate, sent, errors);
        return Reason is null;
    }

    // As for FTP, the pinned key alone decides: a broker inside a plant often has a certificate that expired years ago.
    private string? ReasonOfKey(X509Certificate certificate)
    {
        using var own = new X509Certificate2(certificate);
        var key = "sha256//" + Convert.ToBase64String(SHA256.HashData(own.PublicKey.ExportSubjectPublicKeyInfo()));
        return key == pinnedKey ? null : $"its key is {key}, and {pinnedKey} is pinned";
    }

    private string? ReasonOfAuthority(X509Certificate certificate, X509Chain? sent, SslPolicyErrors errors)
    {
        if (errors.HasFlag(SslPolicyErrors.RemoteCertificateNameMismatch))
        {
            return "its certificate is for another name";
        }

        using var own = new X509Certificate2(certificate);
        using var chain = new X509Chain();
        chain.ChainPolicy.TrustMode = X509ChainTrustMode.CustomRootTrust;
        chain.ChainPolicy.CustomTrustStore.AddRange(authorities!);
        chain.ChainPolicy.ApplicationPolicy.Add(new Oid(ServerAuthentication));

        // A plant's network often reaches no server that tells what was revoked.
        chain.ChainPolicy.RevocationMode = X509RevocationMode.NoCheck;
        chain.ChainPolicy.DisableCertificateDownloads = true;
        if (sent is not null)
        {
            chain.ChainPolicy.ExtraStore.AddRange(sent.ChainPolicy.ExtraStore);
            foreach (var element in sent.ChainElements)
            {
                chain.ChainPolicy.ExtraStore.Add(element.Certificate);
            }
        }

        return chain.Build(own)
            ? null
            : "no configured authority vouches for its certificate: "
                + string.Join(", ", chain.ChainStatus.Select(s => s.Status.ToString()).Distinct(StringComparer.Ordinal));
    }
}
