using System.Buffers.Binary;
using Microsoft.AspNetCore.Identity;
using Microsoft.Extensions.Options;

namespace ErrorMatching.Cell;

/// <summary>Passwords as they are kept: PBKDF2 with HMAC-SHA-512, a salt of 128 bits each, 256 bits of result, by ASP.NET's <see cref="PasswordHasher{TUser}"/>, whose form says its own work factor.</summary>
/// <param name="iterations">The work factor for new hashes.</param>
internal sealed class PasswordHashes(int iterations = PasswordHashes.CurrentIterations)
{
    /// <summary>The work factor. Source: OWASP Password Storage Cheat Sheet (2025), PBKDF2-HMAC-SHA512: 220,000 iterations. Raise it here; hashes follow at their users' next sign-in.</summary>
    public const int CurrentIterations = 220_000;

    private readonly PasswordHasher<PasswordHashes> _hasher = new(Options.Create(new PasswordHasherOptions { IterationCount = iterations }));
    /// <summary>A hash that no password has and that takes as long to compare.</summary>
    public string Nobodys { get; } = NobodysAt(iterations);

    /// <summary>How often a password was compared: once for each answer, whoever asks.</summary>
    public int Comparisons { get; private set; }

    /// <summary>The hash to keep for a password.</summary>
    public string Of(string password) => _hasher.HashPassword(this, password);

    /// <summary>Compares a password.</summary>
    /// <param name="hash">What is kept; null if there is no such user, which takes the same time.</param>
    /// <param name="password">What was typed.</param>
    /// <returns>Whether it is right, and whether the hash is to be made again with today's work factor.</returns>
    public (bool IsRight, bool IsStale) Compare(string? hash, string password)
    {
        Comparisons++;

        // Longer than any password that was ever set: not worth more work than a short one.
        var typed = password.Length > PasswordRule.MostCharacters ? "" : password;
        var result = Verify(hash ?? Nobodys, typed);
        return (hash is not null && typed.Length > 0 && result != PasswordVerificationResult.Failed, result == PasswordVerificationResult.SuccessRehashNeeded);
    }

    private PasswordVerificationResult Verify(string hash, string password)
    {
        try
        {
            return _hasher.VerifyHashedPassword(this, hash, password);
        }
        catch (FormatException)
        {
            // Somebody wrote into the store what is no hash: nobody's password.
            return PasswordVerificationResult.Failed;
        }
    }

    // A hash that no password has, in the hasher's own form, without the time that making a real one takes:
    // format 1, HMAC-SHA-512 as 2, iterations, length of the salt, salt, result.
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
