using System.Buffers.Binary;
using Microsoft.AspNetCore.Identity;
using Microsoft.Extensions.Options;

namespace ErrorMatching.Cell;

/// <summary>Password hashes: PBKDF2 with HMAC-SHA-512, a 128-bit salt each and a 256-bit result, by ASP.NET's
/// <see cref="PasswordHasher{TUser}"/>, whose format includes the work factor.</summary>
/// <param name="iterations">The work factor for new hashes.</param>
internal sealed class PasswordHashes(int iterations)
{
    /// <summary>The work factor. Source: OWASP Password Storage Cheat Sheet (2025), PBKDF2-HMAC-SHA512: 220,000 iterations. Raise it here;
    /// each hash is renewed at its user's next sign-in.</summary>
    public const int CurrentIterations = 220_000;

    private readonly PasswordHasher<PasswordHashes> _hasher = new(Options.Create(
        new PasswordHasherOptions { IterationCount = iterations }));

    /// <summary>Hashes with the work factor of this process.</summary>
    public PasswordHashes()
        : this(Usual)
    {
    }

    /// <summary>The work factor of this process. Only tests lower it, of what stands around passwords: hundreds of sign-ins take minutes
    /// otherwise.</summary>
    public static int Usual { get; set; } = CurrentIterations;

    /// <summary>A hash that matches no password and takes just as long to compare.</summary>
    public string Nobodys { get; } = NobodysAt(iterations);

    /// <summary>Number of password comparisons: one per attempt, for every name.</summary>
    public int Comparisons { get; private set; }

    /// <summary>Hashes a password for storage.</summary>
    public string Of(string password) => _hasher.HashPassword(this, password);

    /// <summary>Compares a password.</summary>
    /// <param name="hash">The stored hash; null if there is no such user, which takes the same time.</param>
    /// <param name="password">The typed password.</param>
    /// <returns>Whether it is right, and whether the hash must be renewed with the current work factor.</returns>
    public (bool IsRight, bool IsStale) Compare(string? hash, string password)
    {
        Comparisons++;

        // Longer than any valid password: it does not deserve more work than a short one.
        var typed = password.Length > PasswordRule.MostCharacters ? "" : password;
        var result = Verify(hash ?? Nobodys, typed);
        return (
            hash is not null && typed.Length > 0 && result != PasswordVerificationResult.Failed,
            result == PasswordVerificationResult.SuccessRehashNeeded);
    }

    private PasswordVerificationResult Verify(string hash, string password)
    {
        try
        {
            return _hasher.VerifyHashedPassword(this, hash, password);
        }
        catch (FormatException)
        {
            // The stored value was changed and is not a hash: no password matches.
            return PasswordVerificationResult.Failed;
        }
    }

    // A hash that matches no password, in the hasher's own format, without the time to compute a real one: format 1, HMAC-SHA-512 as 2,
    // iterations, length of the salt, salt, result.
    private static string NobodysAt(int iterations)
    {
        var hash = new byte[1 + (3 * sizeof(int)) + 16 + 32];
        hash[0] = 1;
        BinaryPrimitives.WriteInt32BigEndian(hash.AsSpan(1), 2);
        BinaryPrimitives.WriteInt32BigEndian(hash.AsSpan(5), iterations);
        BinaryPrimitives.WriteInt32BigEndian(hash.AsSpan(9), 16);
        return Convert.ToBase64String(hash);
    }
}
