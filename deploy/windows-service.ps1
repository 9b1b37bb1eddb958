# Installs a cell as a service of Windows, under an account of its own. Run it once as administrator; docs/install-a-cell.md says what comes before.
#   .\windows-service.ps1 -Program C:\errormatch\errormatch.exe -Config C:\errormatch\cell.json
param(
    [Parameter(Mandatory)] [string] $Program,
    [Parameter(Mandatory)] [string] $Config,
    [string] $Name = 'errormatch-cell',
    # A virtual account, which Windows makes with the service: it has no password, and nobody can log on with it.
    [string] $Account = "NT SERVICE\$Name"
)
$ErrorActionPreference = 'Stop'
foreach ($file in $Program, $Config) {
    if (-not [IO.Path]::IsPathRooted($file)) { throw "$file must be a whole path: a service begins in a folder of Windows." }
    if (-not (Test-Path -LiteralPath $file -PathType Leaf)) { throw "There is no file $file." }
}

# The configuration must be right before anything starts by itself.
& $Program cell check $Config
if ($LASTEXITCODE -ne 0) { throw "errormatch cell check ended with $LASTEXITCODE. Put that right first." }

# Under this name the cell writes into the Event Log why it ended.
if (-not [Diagnostics.EventLog]::SourceExists('errormatch')) { [Diagnostics.EventLog]::CreateEventSource('errormatch', 'Application') }

function Set-Cell { & sc.exe @args | Out-Null; if ($LASTEXITCODE -ne 0) { throw "sc.exe $args ended with $LASTEXITCODE." } }
New-Service -Name $Name -DisplayName 'ErrorMatching cell' -StartupType Automatic `
    -Description 'From the gauge''s file to the machine''s program.' -BinaryPathName "`"$Program`" cell run `"$Config`"" | Out-Null
Set-Cell config $Name obj= $Account start= delayed-auto
# Started again after 5 s, then every minute, also if it ended by itself with an error.
Set-Cell failure $Name reset= 86400 actions= restart/5000/restart/60000/restart/60000
Set-Cell failureflag $Name 1
Start-Service -Name $Name
Start-Sleep -Seconds 5
& $Program cell status $Config
